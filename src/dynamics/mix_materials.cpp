// One rule a property; a hook has the last word, if it makes sense.
#include "dynamics/mix_materials.hpp"

#include "geometry/extent.hpp"

#include <algorithm>
#include <cmath>

namespace carom::detail
{

namespace
{

float mix(Mix rule, float a, float b)
{
    switch (rule)
    {
    case Mix::Average: return 0.5f * (a + b);
    case Mix::Minimum: return std::min(a, b);
    case Mix::Maximum: return std::max(a, b);
    case Mix::Product: return a * b;
    case Mix::GeometricMean: break;
    }
    return std::sqrt(a * b);
}

} // namespace

bool is_friction(float value) { return value >= 0 && value <= max_friction; }

bool is_restitution(float value) { return value >= 0 && value <= 1; }

ContactSurface mix_materials(const Contact& contact, const ShapeStore& shapes, const ContactRules& rules)
{
    const Material& a = shapes.records[contact.shape_a].material;
    const Material& b = shapes.records[contact.shape_b].material;
    const float radius = std::max(rounding(shapes.geometry[contact.shape_a]), rounding(shapes.geometry[contact.shape_b])); // of what rolls
    ContactSurface surface = {.friction = mix(rules.mixing.friction, a.friction, b.friction),
                              .restitution = mix(rules.mixing.restitution, a.restitution, b.restitution),
                              .rolling_resistance = std::max(a.rolling_resistance, b.rolling_resistance) * radius,
                              .tangent_speed = a.tangent_speed + b.tangent_speed};
    if (rules.hooks == nullptr) return surface;

    const float friction = rules.hooks->mix_friction(a, b, surface.friction);
    const float restitution = rules.hooks->mix_restitution(a, b, surface.restitution);
    if (is_friction(friction)) surface.friction = friction;
    if (is_restitution(restitution)) surface.restitution = restitution;
    return surface;
}

void set_roundings(ContactManifold& manifold, const Contact& contact, const ShapeStore& shapes)
{
    manifold.rounding_a = rounding(shapes.geometry[contact.shape_a]);
    manifold.rounding_b = rounding(shapes.geometry[contact.shape_b]);
}

} // namespace carom::detail
