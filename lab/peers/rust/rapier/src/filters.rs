//! Which shapes meet. Rapier has 32 bits of category and mask, and no groups: pairs with a group are decided by a hook.

use carom_peer_scene::file::{Filter, SceneFile};
use carom_peer_scene::run::Stop;
use rapier2d::prelude::*;

fn all(scene: &SceneFile) -> impl Iterator<Item = Filter> {
    scene.all_shapes().map(|shape| shape.filter).chain(scene.all_chains().map(|chain| chain.filter))
}

pub fn check(scene: &SceneFile) -> Result<(), Stop> {
    match all(scene).find(|filter| filter.category > u64::from(u32::MAX)) {
        Some(filter) => Err(Stop::Lacks(format!("the engine has 32 bits for categories; {} takes more", filter.category))),
        None => Ok(()),
    }
}

pub fn needs_hook(scene: &SceneFile) -> bool {
    all(scene).any(|filter| filter.group != 0)
}

/// The bits of categories that nothing has don't count, so cutting masks to 32 bits changes nothing.
pub fn set(collider: &mut Collider, filter: Filter) {
    let (category, mask) = (filter.category as u32, filter.mask as u32);
    collider.user_data = u128::from(category) | u128::from(mask) << 32 | u128::from(filter.group as u32) << 64;
    if filter.group != 0 {
        // Only the hook can tell that two of a group meet against their masks.
        collider.set_collision_groups(InteractionGroups::all());
        collider.set_active_hooks(ActiveHooks::FILTER_CONTACT_PAIRS | ActiveHooks::FILTER_INTERSECTION_PAIR);
    } else {
        let (memberships, meets) = (Group::from_bits_truncate(category), Group::from_bits_truncate(mask));
        collider.set_collision_groups(InteractionGroups::new(memberships, meets, InteractionTestMode::And));
    }
}

/// Decides the pairs of which one at least has a group.
pub struct Hook;

impl Hook {
    fn meet(context: &PairFilterContext) -> bool {
        let part = |data: u128, shift: u32| (data >> shift) as u32;
        let a = context.colliders[context.collider1].user_data;
        let b = context.colliders[context.collider2].user_data;
        let (group, other) = (part(a, 64) as i32, part(b, 64) as i32);
        if group == other && group != 0 {
            return group > 0;
        }
        part(a, 0) & part(b, 32) != 0 && part(b, 0) & part(a, 32) != 0
    }
}

impl PhysicsHooks for Hook {
    fn filter_contact_pair(&self, context: &PairFilterContext) -> Option<SolverFlags> {
        Self::meet(context).then_some(SolverFlags::COMPUTE_RIGID_IMPULSES)
    }
    fn filter_intersection_pair(&self, context: &PairFilterContext) -> bool {
        Self::meet(context)
    }
}
