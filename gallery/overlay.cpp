// Draws contacts, impulses, joints, islands and more, from a live world or from a moment of a step.
#include "gallery/overlay.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

namespace carom::gallery
{

namespace
{

using scenes::Color;
using scenes::DrawList;
using scenes::Layer;
using scenes::Paint;
using scenes::rgb;
using scenes::with_alpha;

constexpr Color point_color = rgb(1, 0.82f, 0.25f);
constexpr Color normal_color = rgb(0.55f, 0.9f, 1);
constexpr Color impulse_color = rgb(1, 0.45f, 0.2f);
constexpr Color friction_color = rgb(0.55f, 0.95f, 0.5f);
constexpr Color joint_color = rgb(0.95f, 0.6f, 0.95f);
constexpr Color velocity_color = rgb(0.45f, 0.75f, 1);
constexpr Color center_color = rgb(1, 1, 1);
constexpr Color sleep_color = {0.35f, 0.38f, 0.45f, 0.8f};
constexpr Color new_pair_color = rgb(1, 0.6f, 0.15f);
constexpr Color old_pair_color = {0.6f, 0.65f, 0.75f, 0.6f};

/// A colour for the n-th of many: neighbours are far apart on the colour circle.
Color color_of(int n)
{
    constexpr float golden_ratio = 0.618034f;
    return scenes::from_hue(golden_ratio * static_cast<float>(n), 0.75f, 0.6f);
}

/// All that an overlay needs to know of a world at a moment.
struct Scenery
{
    struct SeenShape
    {
        ShapeId id;
        BodyId body;
        Geometry geometry;
        Transform transform;
    };
    std::vector<SeenShape> shapes;
    std::vector<DebugBody> bodies;
    std::vector<DebugContact> contacts;
    std::vector<DebugJoint> joints;

    const DebugBody* find(BodyId id) const { return find_in(bodies, id); }
    const SeenShape* find(ShapeId id) const { return find_in(shapes, id); }

private:
    /// Things come by index.
    template <class Thing, class Id>
    static const Thing* find_in(const std::vector<Thing>& things, Id id)
    {
        const auto is_before = [](const Thing& thing, std::uint32_t index) { return thing.id.index < index; };
        const auto place = std::lower_bound(things.begin(), things.end(), id.index, is_before);
        return place != things.end() && place->id == id ? &*place : nullptr;
    }
};

class Collector : public DebugDraw
{
public:
    explicit Collector(Scenery& scenery) : scenery_(scenery) {}

    void shape(ShapeId id, BodyId body, const Geometry& geometry, const Transform& transform) override
    {
        scenery_.shapes.push_back({id, body, geometry, transform});
    }
    void body(const DebugBody& body) override { scenery_.bodies.push_back(body); }
    void contact(const DebugContact& contact) override { scenery_.contacts.push_back(contact); }
    void joint(const DebugJoint& joint) override { scenery_.joints.push_back(joint); }

private:
    Scenery& scenery_;
};

/// Side of a common shape of a body that moves: the median [m]; 0 when there is none.
float common_size(const Scenery& scenery)
{
    std::vector<float> sizes;
    for (const Scenery::SeenShape& shape : scenery.shapes)
    {
        const DebugBody* body = scenery.find(shape.body);
        if (!body || body->type == BodyType::Static) continue;
        const Vec2 size = 2 * aabb_of(shape.geometry, shape.transform).half_extent();
        sizes.push_back(std::max(size.x, size.y));
    }
    if (sizes.empty()) return 0;
    const auto middle = sizes.begin() + static_cast<std::ptrdiff_t>(sizes.size() / 2);
    std::nth_element(sizes.begin(), middle, sizes.end());
    return *middle;
}

/// Marks that fit the picture, but smaller where the bodies are: those of a thousand must not run together.
/// @return radius [m]
float dot_radius(const Scenery& scenery, float height)
{
    const float usual = 0.0045f * height;
    const float size = common_size(scenery);
    return size > 0 ? std::clamp(0.1f * size, 0.0017f * height, usual) : usual;
}

/// Takes colours near to the ground's, so that what is drawn over them stands out.
void dim(DrawList& list)
{
    constexpr float share = 0.62f; // of the ground
    const auto dimmed = [&](Color color) { return with_alpha(scenes::mix(color, list.background, share), color.a); };
    for (const Layer layer : {Layer::Background, Layer::Trails, Layer::Bodies, Layer::Marks})
    {
        for (scenes::DrawnShape& shape : list.layer(layer).shapes)
        {
            shape.paint.fill = dimmed(shape.paint.fill);
            shape.paint.line = dimmed(shape.paint.line);
        }
        for (scenes::DrawnLine& line : list.layer(layer).lines) line.color = dimmed(line.color);
    }
}

/// Draws what a scenery holds, in sizes that suit the part of the world that is seen.
class Pen
{
public:
    Pen(const Scenery& scenery, float height, DrawList& list)
        : scenery_(scenery),
          height_(height),
          dot_(dot_radius(scenery, height)),
          normal_width_(std::min(1.5f, 0.4f * 720 * dot_ / height)),
          list_(list)
    {
    }

    void arrow(Vec2 from, Vec2 way, Color color) const
    {
        const float size = length(way);
        if (!(size > 0.002f * height_)) return;
        const Vec2 tip = from + way;
        const Vec2 back = way * (-std::min(0.3f * size, 0.012f * height_) / size);
        list_.line(Layer::Marks, from, tip, color, 2);
        list_.line(Layer::Marks, tip, tip + back + 0.5f * left_perp(back), color, 2);
        list_.line(Layer::Marks, tip, tip + back - 0.5f * left_perp(back), color, 2);
    }

    void dot(Vec2 at, Color color, float share = 1) const { list_.disc(Layer::Marks, at, share * dot_, {.fill = color}); }

    void contact_points() const
    {
        for_each_point([&](const DebugContact& contact, const ContactPoint& point)
        {
            const Vec2 n = dot_ * contact.manifold.normal;
            list_.line(Layer::Marks, point.position + 0.8f * n, point.position + 3.5f * n, normal_color, normal_width_);
            dot(point.position, contact.is_touching ? point_color : with_alpha(point_color, 0.4f));
        });
    }

    /// The largest impulse of all has the longest arrow.
    void impulses() const
    {
        float largest = 0;
        for_each_point([&](const DebugContact&, const ContactPoint& point)
        { largest = std::max({largest, point.normal_impulse, std::abs(point.tangent_impulse)}); });
        if (largest > 0)
        {
            const float scale = 0.09f * height_ / largest;
            for_each_point([&](const DebugContact& contact, const ContactPoint& point)
            {
                const Vec2 n = contact.manifold.normal;
                arrow(point.position, scale * point.normal_impulse * n, impulse_color);
                arrow(point.position, scale * point.tangent_impulse * right_perp(n), friction_color);
            });
        }
        joint_forces();
    }

    void joints() const
    {
        for (const DebugJoint& joint : scenery_.joints)
        {
            const DebugBody* a = scenery_.find(joint.body_a);
            const DebugBody* b = scenery_.find(joint.body_b);
            if (a) list_.line(Layer::Marks, a->center_of_mass, joint.anchor_a, with_alpha(joint_color, 0.6f), 1.5f);
            if (b) list_.line(Layer::Marks, b->center_of_mass, joint.anchor_b, with_alpha(joint_color, 0.6f), 1.5f);
            list_.line(Layer::Marks, joint.anchor_a, joint.anchor_b, joint_color, 1.5f);
            dot(joint.anchor_a, joint_color);
            dot(joint.anchor_b, joint_color, 0.6f);
        }
    }

    /// Lines between the bodies of each contact that the solver works on, in the colour of its group.
    void graph_colors() const
    {
        for (const DebugContact& contact : scenery_.contacts)
        {
            if (contact.color < 0 || contact.manifold.point_count == 0) continue;
            const Color color = color_of(contact.color);
            const Vec2 point = contact.manifold.points[0].position;
            for (const ShapeId id : {contact.shape_a, contact.shape_b})
            {
                const Scenery::SeenShape* shape = scenery_.find(id);
                const DebugBody* body = shape ? scenery_.find(shape->body) : nullptr;
                if (body && body->type == BodyType::Dynamic) list_.line(Layer::Marks, body->center_of_mass, point, color, 2.5f);
            }
            dot(point, color);
        }
    }

    void islands() const
    {
        std::unordered_map<int, int> first_bodies; // an island's colour stays as long as its first body does
        for (const DebugBody& body : scenery_.bodies)
            if (body.island >= 0) first_bodies.try_emplace(body.island, static_cast<int>(body.id.index));
        tint([&](const DebugBody& body)
        { return body.island < 0 ? Color{} : with_alpha(color_of(first_bodies.at(body.island)), body.is_awake ? 0.75f : 0.35f); });
    }

    void sleepers() const
    {
        tint([](const DebugBody& body) { return body.type == BodyType::Static || body.is_awake ? Color{} : sleep_color; });
    }

    void velocities() const
    {
        constexpr float seconds = 0.1f;
        for (const DebugBody& body : scenery_.bodies)
            if (body.type != BodyType::Static) arrow(body.center_of_mass, seconds * body.linear_velocity, velocity_color);
    }

    void mass_centers() const
    {
        for (const DebugBody& body : scenery_.bodies)
        {
            if (body.type == BodyType::Static) continue;
            const float size = 0.008f * height_;
            const Vec2 x = rotate(body.transform.q, Vec2{size, 0});
            list_.line(Layer::Marks, body.center_of_mass - x, body.center_of_mass + x, center_color, 1.5f);
            list_.line(Layer::Marks, body.center_of_mass - left_perp(x), body.center_of_mass + left_perp(x), center_color, 1.5f);
        }
    }

private:
    template <class Visit>
    void for_each_point(const Visit& visit) const
    {
        for (const DebugContact& contact : scenery_.contacts)
            for (int i = 0; i < contact.manifold.point_count; ++i) visit(contact, contact.manifold.points[static_cast<std::size_t>(i)]);
    }

    void joint_forces() const
    {
        float largest = 0;
        for (const DebugJoint& joint : scenery_.joints) largest = std::max(largest, length(joint.force));
        if (!(largest > 0) || !std::isfinite(largest)) return;
        for (const DebugJoint& joint : scenery_.joints) arrow(joint.anchor_b, 0.09f * height_ / largest * joint.force, joint_color);
    }

    template <class Tint>
    void tint(const Tint& color_of_body) const
    {
        for (const Scenery::SeenShape& shape : scenery_.shapes)
        {
            const DebugBody* body = scenery_.find(shape.body);
            if (!body) continue;
            const Color color = color_of_body(*body);
            if (color.a > 0)
                list_.shape(Layer::Bodies, shape.geometry, shape.transform, {.fill = color, .line = scenes::darker(color, 0.3f)});
        }
    }

    const Scenery& scenery_;
    float height_;
    float dot_;          ///< radius of a point's mark [m]
    float normal_width_; ///< of its normal, which must not hide it [1/720 of the picture's height]
    DrawList& list_;
};

/// Keeps names off each other: nobody could read them, and thousands take most of a second to draw.
class NameRoom
{
public:
    /// @param height of the part of the world that is seen [m]
    explicit NameRoom(float height) : size_{0.05f * height, 0.02f * height} {}

    /// @return whether the place was free
    bool take(Vec2 at)
    {
        const float column = std::floor(at.x / size_.x);
        const float row = std::floor(at.y / size_.y);
        for (const float x : {column - 1, column, column + 1})
            for (const float y : {row - 1, row, row + 1})
                if (const auto near = taken_.find({x, y}); near != taken_.end() && covers(near->second, at)) return false;
        taken_[{column, row}] = at;
        return true;
    }

private:
    bool covers(Vec2 a, Vec2 b) const { return std::abs(a.x - b.x) < size_.x && std::abs(a.y - b.y) < size_.y; }

    Vec2 size_;                                     ///< of a short name [m]
    std::map<std::pair<float, float>, Vec2> taken_; ///< by cells of this size, each of which has room for one
};

void draw_names(const World& world, const Scenery& scenery, float height, DrawList& list)
{
    NameRoom room(height);
    for (const DebugBody& body : scenery.bodies)
    {
        const std::string_view name = world.body(body.id).name();
        if (name.empty() && body.type == BodyType::Static) continue;
        const Vec2 at = body.center_of_mass;
        if (!room.take(at)) continue;
        std::string text = name.empty() ? "#" + std::to_string(body.id.index) : std::string(name);
        list.text({.text = std::move(text), .size = 13, .place = scenes::Place::World, .position = at});
    }
}

/// What is drawn over the bodies, with thin lines and small points.
bool wants_marks(const DrawOptions& o) { return o.mass_centers || o.contacts || o.impulses || o.joints || o.colors || o.velocities; }

bool wants_anything(const DrawOptions& o) { return wants_marks(o) || o.islands || o.sleep || o.names; }

void draw_plain(const StepFilm& film, const Moment& moment, DrawList& list)
{
    for (std::size_t i = 0; i < moment.poses.size(); ++i)
    {
        const FilmShape& shape = film.shapes()[i];
        const Color fill = shape.is_dynamic ? Color{0.40f, 0.46f, 0.58f, 0.55f} : Color{0.30f, 0.33f, 0.40f, 0.8f};
        list.shape(Layer::Bodies, shape.geometry, moment.poses[i],
                   {.fill = fill, .line = with_alpha(scenes::paper, 0.5f), .line_width = 1});
    }
}

/// Where the shapes were at the moment before, when they moved.
void draw_ghosts(const StepFilm& film, const Moment& before, const Moment& moment, DrawList& list)
{
    for (std::size_t i = 0; i < moment.poses.size(); ++i)
        if (before.poses[i] != moment.poses[i])
            list.shape(Layer::Trails, film.shapes()[i].geometry, before.poses[i], {.line = {1, 1, 1, 0.35f}, .line_width = 1});
}

void draw_pairs(const StepFilm& film, const Moment& moment, DrawList& list)
{
    std::unordered_map<std::uint32_t, Vec2> middles;
    for (std::size_t i = 0; i < moment.poses.size(); ++i)
        middles[film.shapes()[i].id.index] = aabb_of(film.shapes()[i].geometry, moment.poses[i]).center();
    for (const FilmPair& pair : moment.pairs)
        list.line(Layer::Marks, middles[pair.shape_a.index], middles[pair.shape_b.index], pair.is_new ? new_pair_color : old_pair_color,
                  pair.is_new ? 3 : 1.5f);
}

Scenery scenery_of(const StepFilm& film, const Moment& moment)
{
    Scenery scenery;
    for (std::size_t i = 0; i < moment.poses.size(); ++i)
        scenery.shapes.push_back({film.shapes()[i].id, film.shapes()[i].body, film.shapes()[i].geometry, moment.poses[i]});
    scenery.bodies = moment.bodies;
    scenery.contacts = moment.contacts;
    scenery.joints = moment.joints;
    return scenery;
}

void draw_stage(const StepFilm& film, const Moment& moment, const Pen& pen, DrawList& list)
{
    switch (moment.when.stage)
    {
    case Stage::FindPairs: return draw_pairs(film, moment, list);
    case Stage::UpdateManifolds:
    case Stage::EmitEvents: return pen.contact_points();
    case Stage::BuildRows: pen.islands(); return pen.graph_colors();
    case Stage::Restitution:
    case Stage::IntegrateVelocities:
    case Stage::IntegratePositions:
    case Stage::FinalizeBodies:
    case Stage::Continuous: return pen.velocities();
    case Stage::WarmStart:
    case Stage::Solve:
    case Stage::Relax:
    case Stage::StoreImpulses:
        pen.joints();
        pen.contact_points();
        return pen.impulses();
    case Stage::Sleep: pen.islands(); return pen.sleepers();
    }
}

} // namespace

void draw_overlay(const World& world, const DrawOptions& options, float height, DrawList& list)
{
    if (!wants_anything(options)) return;
    Scenery scenery;
    Collector collector(scenery);
    world.debug_draw(collector, DrawPart::Shapes | DrawPart::Bodies | DrawPart::Contacts | DrawPart::Joints);
    const Pen pen(scenery, height, list);
    if (options.islands) pen.islands();
    if (options.sleep) pen.sleepers();
    if (wants_marks(options)) dim(list);
    if (options.colors) pen.graph_colors();
    if (options.joints) pen.joints();
    if (options.contacts) pen.contact_points();
    if (options.impulses) pen.impulses();
    if (options.velocities) pen.velocities();
    if (options.mass_centers) pen.mass_centers();
    if (options.names) draw_names(world, scenery, height, list);
}

void draw_moment(const StepFilm& film, std::size_t index, float height, DrawList& list)
{
    const Moment& moment = film.moments()[index];
    draw_plain(film, moment, list);
    if (index > 0) draw_ghosts(film, film.moments()[index - 1], moment, list);
    if (moment.is_start) return;
    const Scenery scenery = scenery_of(film, moment);
    draw_stage(film, moment, Pen(scenery, height, list), list);
}

void draw_outline(const World& world, BodyId body, Color color, DrawList& list)
{
    const std::optional<BodyView> view = world.find_body(body);
    if (!view) return;
    for (const ShapeId shape : view->shapes())
        list.shape(Layer::Marks, world.shape(shape).geometry(), view->transform(), {.line = color, .line_width = 3});
}

} // namespace carom::gallery
