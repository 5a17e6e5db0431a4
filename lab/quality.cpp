// Measures the states that an engine told of.
#include "lab/quality.hpp"

#include "lab/passages.hpp"
#include "scene_file/player.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace carom::lab
{

namespace
{

/// Depths of overlap in a world.
class Overlaps : public DebugDraw
{
public:
    void contact(const DebugContact& contact) override
    {
        float deepest = 0;
        bool is_touching = false;
        for (int i = 0; i < contact.manifold.point_count; ++i)
        {
            const float separation = contact.manifold.points[static_cast<std::size_t>(i)].separation;
            constexpr float touching = 0.001f; // [m]
            is_touching = is_touching || separation < touching;
            deepest = std::max(deepest, -separation);
        }
        if (!is_touching) return;
        ++count;
        sum += static_cast<double>(deepest);
        most = std::max(most, static_cast<double>(deepest));
    }

    int count = 0;
    double sum = 0;
    double most = 0;
};

bool is_sound(const BodySample& b)
{
    const auto is_place = [](double x) { return std::abs(x) <= static_cast<double>(max_coordinate); }; // nor NaN
    const auto is_speed = [](double v) { return std::abs(v) <= static_cast<double>(max_speed); };
    return is_place(b.x) && is_place(b.y) && std::isfinite(b.angle) && is_speed(b.vx) && is_speed(b.vy) && is_speed(b.w);
}

Vec2 vector(double x, double y) { return {static_cast<float>(x), static_cast<float>(y)}; }

WorldDef still_world(const SceneFile& file)
{
    WorldDef def = FilePlayback::world_def(file);
    def.sleep.is_enabled = false;
    def.continuous = false;
    return def;
}

/// The scene's bodies where a sample has them.
class Stage
{
public:
    explicit Stage(const SceneFile& file) : name_("scene"), playback_(file, name_), world_(still_world(file)) { playback_.begin(world_); }

    /// @param sample of a later step than the one before
    void show(const Sample& sample)
    {
        for (; step_ < sample.step; ++step_) playback_.before_step(world_, step_);
        lost = 0;
        for (int i = 0; i < playback_.body_count(); ++i) show(i, sample);
        world_.step(0);
    }

    template <class Visit>
    void for_each_moving(const Visit& visit) const
    {
        for (int i = 0; i < playback_.body_count(); ++i)
        {
            const std::optional<BodyView> body = world_.find_body(playback_.body(i));
            if (body && body->type() == BodyType::Dynamic && body->is_enabled()) visit(i, *body);
        }
    }

    Overlaps overlaps() const
    {
        Overlaps overlaps;
        world_.debug_draw(overlaps, DrawPart::Contacts);
        return overlaps;
    }

    bool has_joints() const { return playback_.joint_count() > 0; }

    double joint_separation() const
    {
        float most = 0;
        for (const JointId id : world_.joints()) most = std::max(most, world_.joint(id).error());
        return static_cast<double>(most);
    }

    double kinetic_energy() const
    {
        double energy = 0;
        for_each_moving([&](int, const BodyView& body)
        {
            const MassData mass = body.mass_data();
            const double v = static_cast<double>(length(body.linear_velocity()));
            const double w = static_cast<double>(body.angular_velocity());
            energy += 0.5 * (static_cast<double>(mass.mass) * v * v + static_cast<double>(mass.inertia) * w * w);
        });
        return energy;
    }

    double energy() const
    {
        double height_energy = 0;
        const Vec2 gravity = world_.gravity();
        for_each_moving([&](int, const BodyView& body)
        {
            const Vec2 p = body.center_of_mass();
            height_energy -= static_cast<double>(body.mass_data().mass) * static_cast<double>(dot(gravity, p)) *
                             static_cast<double>(body.gravity_scale());
        });
        return kinetic_energy() + height_energy;
    }

    double mass() const
    {
        double sum = 0;
        for_each_moving([&](int, const BodyView& body) { sum += static_cast<double>(body.mass_data().mass); });
        return sum;
    }

    /// The sum of momenta, and the sum of their sizes [kg m/s].
    std::pair<Vec2, double> momentum() const
    {
        double x = 0;
        double y = 0;
        double sizes = 0;
        for_each_moving([&](int, const BodyView& body)
        {
            const double mass = static_cast<double>(body.mass_data().mass);
            const Vec2 v = body.linear_velocity();
            x += mass * static_cast<double>(v.x);
            y += mass * static_cast<double>(v.y);
            sizes += mass * static_cast<double>(length(v));
        });
        return {vector(x, y), sizes};
    }

    /// Of all that is not dynamic, however it turns about its middle [m].
    std::optional<Aabb> walls() const
    {
        std::optional<Aabb> bounds;
        for (const BodyId id : world_.bodies())
        {
            const BodyView body = world_.body(id);
            if (body.type() == BodyType::Dynamic || body.shape_count() == 0) continue;
            bounds = bounds ? merge(*bounds, body.bounds()) : body.bounds();
        }
        if (!bounds) return std::nullopt;
        const float reach = length(bounds->half_extent());
        return Aabb{bounds->center() - Vec2{reach, reach}, bounds->center() + Vec2{reach, reach}};
    }

    const World& world() const { return world_; }

    double gravity() const { return static_cast<double>(length(world_.gravity())); }

    int lost = 0; ///< bodies of the sample that is shown

private:
    void show(int number, const Sample& sample)
    {
        const auto index = static_cast<std::size_t>(number);
        std::optional<Body> body = world_.find_body(playback_.body(number));
        if (!body || index >= sample.bodies.size() || !sample.bodies[index]) return;
        const BodySample& state = *sample.bodies[index];
        if (!is_sound(state))
        {
            ++lost;
            return body->set_enabled(false);
        }
        body->set_transform(vector(state.x, state.y), static_cast<float>(state.angle));
        if (body->type() == BodyType::Static) return;
        body->set_linear_velocity(vector(state.vx, state.vy));
        body->set_angular_velocity(static_cast<float>(state.w));
    }

    std::string name_;
    FilePlayback playback_;
    World world_;
    int step_ = 0; ///< the next one to be played
};

/// By number, where the moving bodies are.
std::map<int, Vec2> places_of(const Stage& stage)
{
    std::map<int, Vec2> places;
    stage.for_each_moving([&](int number, const BodyView& body) { places[number] = body.center_of_mass(); });
    return places;
}

double drift_of(const Stage& stage, const std::map<int, Vec2>& start)
{
    float most = 0;
    stage.for_each_moving([&](int number, const BodyView& body)
    {
        const auto place = start.find(number);
        if (place != start.end()) most = std::max(most, distance(place->second, body.center_of_mass()));
    });
    return static_cast<double>(most);
}

double escapes_of(const Stage& stage, const Aabb& walls)
{
    int count = 0;
    stage.for_each_moving([&](int, const BodyView& body) { count += contains(walls, body.center_of_mass()) ? 0 : 1; });
    return count;
}

} // namespace

std::map<std::string, double> quality_of(const SceneFile& file, const std::vector<Sample>& samples, const QualityTraits& traits)
{
    Stage stage(file);
    const std::map<int, Vec2> start = places_of(stage);
    const double kinetic_at_start = stage.kinetic_energy();
    const double energy_at_start = stage.energy();
    const auto [momentum_at_start, momenta_at_start] = stage.momentum();
    const std::optional<Aabb> walls = stage.walls();
    const double scale = kinetic_at_start > 0 ? kinetic_at_start : stage.mass() * stage.gravity();

    double deepest = 0;
    double sum = 0;
    int contacts = 0;
    double separation = 0;
    double energy_error = 0;
    double momentum_change = 0;
    int lost = 0;
    Passages passages;
    for (const Sample& sample : samples)
    {
        stage.show(sample);
        if (traits.has_shots) passages.look(stage.world(), sample.step);
        const Overlaps overlaps = stage.overlaps();
        deepest = std::max(deepest, overlaps.most);
        sum += overlaps.sum;
        contacts += overlaps.count;
        separation = std::max(separation, stage.joint_separation());
        if (scale > 0) energy_error = std::max(energy_error, std::abs(stage.energy() - energy_at_start) / scale);
        momentum_change = std::max(momentum_change, static_cast<double>(length(stage.momentum().first - momentum_at_start)));
        lost = std::max(lost, stage.lost);
    }

    std::map<std::string, double> quality = {
        {"deepest_penetration_m", deepest}, {"mean_penetration_m", contacts > 0 ? sum / contacts : 0}, {"lost", lost}};
    if (const auto tunnelled = passages.count()) quality["tunnelled"] = *tunnelled;
    if (stage.has_joints()) quality["joint_separation_m"] = separation;
    const double mass = stage.mass();
    if (traits.rests && mass > 0) quality["rest_energy_j_per_kg"] = stage.kinetic_energy() / mass;
    if (traits.stands) quality["drift_m"] = drift_of(stage, start);
    if (traits.keeps_energy) quality["energy_error"] = energy_error;
    if (traits.keeps_momentum && momenta_at_start > 0) quality["momentum_error"] = momentum_change / momenta_at_start;
    if (traits.is_closed && walls) quality["escapes"] = escapes_of(stage, *walls);
    return quality;
}

} // namespace carom::lab
