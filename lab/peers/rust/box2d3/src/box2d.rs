//! Which Box2D 3 this is: the revision that the crate boxdd-sys brings, or a checkout of the user's.

#[cfg(not(feature = "source"))]
mod chosen {
    pub use boxdd_sys::ffi;

    pub const NAME: &str = "box2d3";

    pub fn revision() -> &'static str {
        &boxdd_sys::UPSTREAM_SHA[..7]
    }

    /// # Safety
    /// As that of b2DestroyJoint.
    pub unsafe fn destroy_joint(joint: ffi::b2JointId) {
        unsafe { ffi::b2DestroyJoint(joint, true) };
    }
}

#[cfg(feature = "source")]
mod chosen {
    pub use box2d_source::{destroy_joint, ffi};

    pub const NAME: &str = "box2d3-source";

    pub fn revision() -> &'static str {
        box2d_source::REVISION
    }
}

pub use chosen::*;
