// The surface of a contact, from those of its two shapes.
#pragma once

#include "dynamics/contact_rules.hpp"
#include "dynamics/contact_store.hpp"
#include "dynamics/shape_store.hpp"

namespace carom::detail
{

/// By the world's rules, and by its hooks if there are any.
ContactSurface mix_materials(const Contact& contact, const ShapeStore& shapes, const ContactRules& rules);

/// Tells a contact how round its shapes are: once, and again when one of them becomes another.
void set_roundings(ContactManifold& manifold, const Contact& contact, const ShapeStore& shapes);

/// Largest friction and rolling resistance that are taken: beyond, products leave the range of float.
inline constexpr float max_friction = 1e6f;

/// Ranges of Material; false for NaN.
bool is_friction(float value);
bool is_restitution(float value);

} // namespace carom::detail
