//! Box2D 3 as a checkout has it. `ffi` is what bindgen makes of its headers.

#[allow(non_upper_case_globals, non_camel_case_types, non_snake_case, dead_code, clippy::all, unsafe_op_in_unsafe_fn)]
pub mod ffi {
    include!(concat!(env!("OUT_DIR"), "/bindings.rs"));
}

/// Of the checkout's commit the first seven digits.
pub const REVISION: &str = env!("BOX2D_REVISION");

/// @param joint there, and not destroyed yet
/// # Safety
/// As that of b2DestroyJoint.
pub unsafe fn destroy_joint(joint: ffi::b2JointId) {
    #[cfg(destroying_asks_to_wake)]
    unsafe {
        ffi::b2DestroyJoint(joint, true)
    };
    #[cfg(not(destroying_asks_to_wake))]
    unsafe {
        ffi::b2DestroyJoint(joint)
    };
}
