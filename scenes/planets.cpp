// Planets: a sun, and planets on orbits around it. More of both can be added, and suns pull each other too.
#include "scenes/builtin_scenes.hpp"
#include "scenes/framing.hpp"
#include "scenes/helpers.hpp"

#include <algorithm>
#include <cmath>

namespace carom::scenes
{

namespace
{

constexpr float sun_density = 60;         // [kg/m^2], makes the default sun 4 m in radius
constexpr float planet_density = 0.35f;   // [kg/m^2], makes the default planet half a metre in radius
constexpr float inner_orbit = 9;          // [m]
constexpr float outer_orbit = 58;         // [m], with the default number of planets
constexpr float usual_planets = 250;      // as many find room between the two
constexpr float farthest = 5000;          // [m], a planet that was flung beyond is taken away
constexpr std::size_t trail_points = 28;  // positions that a trail joins
constexpr int steps_between_points = 2;   // of a trail
constexpr std::size_t most_trails = 2000; // more would hide the planets

constexpr Color sun_color = rgb(1.0f, 0.86f, 0.32f);

/// Bodies of one negative group never meet; group 0 leaves them to collide.
Filter filter_for(bool collide) { return {.group = collide ? 0 : -1}; }

/// Radius of a disc of a mass [kg] and a density [kg/m^2].
float radius_of(float mass, float density) { return std::sqrt(mass / (pi * density)); }

NBodyField field_from(const Parameters& parameters)
{
    return {.gravitational_constant = parameters.real("G"),
            .softening = parameters.real("softening"),
            .method = parameters.choice("method") == "direct" ? NBodyMethod::Direct : NBodyMethod::BarnesHut,
            .sources = parameters.boolean("n_body") ? NBodySources::All : NBodySources::Attractors,
            .opening_angle = parameters.real("opening_angle")};
}

class Planets : public Scene
{
public:
    explicit Planets(const SceneSetup& setup);

private:
    struct Planet
    {
        BodyId body;
        Color color;
        float radius;
        std::vector<Vec2> trail; ///< a ring of positions; trail_next_ is the oldest
    };
    struct Sun
    {
        BodyId body;
        float radius;
    };

    void add_sun(Vec2 position, Vec2 velocity, float mass);
    void add_planet(Vec2 position, Vec2 velocity, float mass);
    void add_first_planets(int count);
    /// The velocity of a circular orbit around the nearest sun; zero when there is no sun.
    /// @param pulling_mass of the body on the orbit, zero when it does not pull the sun [kg]
    Vec2 orbit_velocity(Vec2 position, float pulling_mass) const;
    std::optional<BodyId> nearest_sun(Vec2 position) const;

    void remove_lost();
    void extend_trails();
    void follow_sun();
    void set_collide(bool collide);

    void on_parameter(std::string_view name) override;
    void on_pointer(const PointerEvent& event) override;
    void on_key(std::string_view name) override;
    void after_step(const StepReport& report) override;
    void on_draw(DrawList& list) const override;
    void draw_sun(DrawList& list, const Sun& sun) const;
    void draw_trail(DrawList& list, const Planet& planet) const;
    std::string status() const override;

    Random random_;
    FieldId field_;
    std::vector<Sun> suns_;
    std::vector<Planet> planets_;
    std::size_t trail_next_ = 0;
    std::vector<DrawnShape> stars_;
};

/// How far out the planets go, so that each has as much room as with the usual number.
float orbits_end(int planets) { return outer_orbit * std::sqrt(std::max(1.0f, static_cast<float>(planets) / usual_planets)); }

Planets::Planets(const SceneSetup& setup) : Scene(setup, {.gravity = {}}), random_(seed(), 1)
{
    field_ = world().add_field(field_from(parameters()));
    add_sun({}, {}, real("sun_mass"));
    add_first_planets(integer("planets"));
    const Vec2 end = orbits_end(integer("planets")) * Vec2{1, 1};
    camera_ = framed_field({-end, end});

    Random star_random(seed(), 2);
    const Vec2 half = camera_.height * Vec2{1.2f, 0.6f};
    for (int i = 0; i < 350; ++i)
    {
        const Vec2 place = star_random.point_in({-half, half});
        const float size = camera_.height * star_random.uniform(0.0004f, 0.0013f);
        const float brightness = star_random.uniform(0.15f, 0.6f);
        stars_.push_back({circle(size), {.p = place, .q = {}}, {.fill = with_alpha(paper, brightness)}});
    }
}

void Planets::add_sun(Vec2 position, Vec2 velocity, float mass)
{
    const float radius = radius_of(mass, sun_density);
    const BodyDef def{.position = position, .linear_velocity = velocity, .is_attractor = true, .name = "sun"};
    const BodyId body = world().create_body(def, circle(radius), {.density = sun_density, .filter = filter_for(boolean("collide"))});
    suns_.push_back({body, radius});
}

void Planets::add_planet(Vec2 position, Vec2 velocity, float mass)
{
    const float radius = radius_of(mass, planet_density);
    const BodyDef def{.position = position, .linear_velocity = velocity, .name = "planet"};
    const BodyId body = world().create_body(def, circle(radius), {.density = planet_density, .filter = filter_for(boolean("collide"))});

    // The farther from its sun, the colder its colour.
    const std::optional<BodyId> sun = nearest_sun(position);
    const float away = sun ? distance(world().body(*sun).position(), position) / outer_orbit : 1;
    const float hue = 0.04f + 0.62f * std::min(1.0f, away) + random_.uniform(-0.05f, 0.05f);
    planets_.push_back({body, from_hue(hue, 0.6f, 0.64f), radius, std::vector<Vec2>(trail_points, position)});
}

void Planets::add_first_planets(int count)
{
    const float end = orbits_end(count);
    for (int i = 0; i < count; ++i)
    {
        // The square root spreads them evenly over the area.
        const float radius = std::sqrt(random_.uniform(inner_orbit * inner_orbit, end * end));
        const Vec2 position = radius * random_.direction();
        const float mass = real("planet_mass") * random_.uniform(0.3f, 2.5f);
        add_planet(position, orbit_velocity(position, boolean("n_body") ? mass : 0), mass);
    }
}

/// Two bodies circle each other when the pull supplies what the circle needs:
///   v^2 / d = G (m_sun + m) d / (d^2 + softening^2)^(3/2)
/// with v and d the velocity and the place of the one as seen from the other.
Vec2 Planets::orbit_velocity(Vec2 position, float pulling_mass) const
{
    const std::optional<BodyId> sun = nearest_sun(position);
    if (!sun) return {};
    const BodyView center = world().body(*sun);
    const Vec2 offset = position - center.position();
    const float softening = real("softening");
    const float squared = length_squared(offset) + softening * softening;
    if (squared <= 0) return center.linear_velocity();
    const float strength = real("G") * (center.mass_data().mass + pulling_mass) / (squared * std::sqrt(squared));
    return center.linear_velocity() + std::sqrt(strength) * left_perp(offset);
}

std::optional<BodyId> Planets::nearest_sun(Vec2 position) const
{
    const auto squared = [&](const Sun& sun) { return length_squared(world().body(sun.body).position() - position); };
    const auto nearest = std::min_element(suns_.begin(), suns_.end(), [&](const Sun& a, const Sun& b) { return squared(a) < squared(b); });
    if (nearest == suns_.end()) return std::nullopt;
    return nearest->body;
}

void Planets::on_parameter(std::string_view name)
{
    if (name == "collide") set_collide(boolean(name));
    world().set_field(field_, field_from(parameters()));
}

void Planets::set_collide(bool collide)
{
    for (const BodyId body : world().bodies())
    {
        for (const ShapeId shape : world().body(body).shapes()) world().shape(shape).set_filter(filter_for(collide));
    }
}

void Planets::on_pointer(const PointerEvent& event)
{
    const bool is_left = event.button == PointerEvent::Button::Left;
    const bool is_right = event.button == PointerEvent::Button::Right;
    if (event.action != PointerEvent::Action::Down || (!is_left && !is_right)) return;
    if (!may_add_at(event.position)) return;
    const float sun_mass = real("sun_mass");
    const float planet_mass = real("planet_mass");
    if (is_left) add_planet(event.position, orbit_velocity(event.position, boolean("n_body") ? planet_mass : 0), planet_mass);
    if (is_right) add_sun(event.position, orbit_velocity(event.position, sun_mass), sun_mass);
}

void Planets::on_key(std::string_view name)
{
    if (name == "f") toggle("follow");
    if (name == "t") toggle("trails");
    if (name == "n") toggle("n_body");
    if (name == "c") toggle("collide");
}

void Planets::after_step(const StepReport&)
{
    remove_lost();
    if (world().step_count() % steps_between_points == 0) extend_trails();
    if (boolean("follow")) follow_sun();
}

void Planets::remove_lost()
{
    const auto is_lost = [&](const auto& thing)
    {
        if (length_squared(world().body(thing.body).position()) < farthest * farthest) return false;
        world().destroy_body(thing.body);
        return true;
    };
    std::erase_if(planets_, is_lost);
    std::erase_if(suns_, is_lost);
}

void Planets::extend_trails()
{
    for (Planet& planet : planets_) planet.trail[trail_next_] = world().body(planet.body).position();
    trail_next_ = (trail_next_ + 1) % trail_points;
}

void Planets::follow_sun()
{
    if (const std::optional<BodyId> sun = nearest_sun(camera_.center)) camera_.center = world().body(*sun).position();
}

void Planets::on_draw(DrawList& list) const
{
    list.background = rgb(0.027f, 0.031f, 0.055f);
    for (const DrawnShape& star : stars_)
        list.disc(Layer::Background, camera_.center + star.transform.p, std::get<Circle>(star.geometry).radius, star.paint);
    const bool has_trails = boolean("trails") && planets_.size() <= most_trails;
    for (const Planet& planet : planets_)
    {
        if (has_trails) draw_trail(list, planet);
        list.disc(Layer::Bodies, world().body(planet.body).position(), planet.radius, {.fill = planet.color});
    }
    for (const Sun& sun : suns_) draw_sun(list, sun);
}

void Planets::draw_sun(DrawList& list, const Sun& sun) const
{
    const Vec2 center = world().body(sun.body).position();
    constexpr int rings = 9;
    for (int i = rings; i > 0; --i)
    {
        const float size = 1 + 0.16f * static_cast<float>(i);
        list.disc(Layer::Trails, center, size * sun.radius, {.fill = with_alpha(rgb(1, 0.7f, 0.2f), 0.045f)});
    }
    list.disc(Layer::Bodies, center, sun.radius, {.fill = sun_color});
    list.disc(Layer::Bodies, center, 0.82f * sun.radius, {.fill = lighter(sun_color, 0.35f)});
}

void Planets::draw_trail(DrawList& list, const Planet& planet) const
{
    Vec2 from = planet.trail[trail_next_];
    for (std::size_t i = 1; i <= trail_points; ++i)
    {
        const bool is_last = i == trail_points;
        const Vec2 to = is_last ? world().body(planet.body).position() : planet.trail[(trail_next_ + i) % trail_points];
        const float age = static_cast<float>(i) / static_cast<float>(trail_points);
        list.line(Layer::Trails, from, to, with_alpha(planet.color, 0.5f * age * age), 1.6f);
        from = to;
    }
}

std::string Planets::status() const
{
    const std::string suns = std::to_string(suns_.size()) + (suns_.size() == 1 ? " sun, " : " suns, ");
    return suns + std::to_string(planets_.size()) + " planets" + (boolean("n_body") ? ", everything pulls everything" : "");
}

} // namespace

SceneInfo planets_scene()
{
    return {
        .name = "planets",
        .title = "Planets",
        .description = "A sun and planets on circular orbits. A body that is added starts on a circular orbit around the nearest sun. "
                       "Suns pull planets and each other; with n_body everything pulls everything. Planets pass through each other "
                       "unless collide is on.",
        .group = "Gravity",
        .controls = with_common_controls({
            {Control::Kind::Pointer, "left", "add a planet of mass planet_mass"},
            {Control::Kind::Pointer, "right", "add a sun of mass sun_mass"},
            {Control::Kind::Key, "f", "follow the nearest sun with the camera, or stop following"},
            {Control::Kind::Key, "t", "show or hide trails"},
            {Control::Kind::Key, "n", "let everything pull everything, or suns only"},
            {Control::Kind::Key, "c", "let bodies collide, or pass through each other"},
        }),
        .parameters = with_common_parameters({
            integer("planets", {0, 250, 20000}, "", Applies::OnRestart, "planets at the start"),
            real("planet_mass", {0.01, 0.3, 1000}, "kg", Applies::Live, "of the next planet; the first ones have 0.3 to 2.5 times as much"),
            real("sun_mass", {10, 3000, 100000}, "kg", Applies::Live, "of the next sun"),
            real("G", {0, 1, 100}, "m^3/(kg s^2)", Applies::Live, "gravitational constant"),
            real("softening", {0, 0.5, 10}, "m", Applies::Live, "distance within which the pull stops growing"),
            boolean("n_body", false, Applies::Live, "everything pulls everything, not only suns"),
            choice("method", {"barnes-hut", "direct"}, Applies::Live, "how pulls are summed: far groups as one mass, or every pair"),
            real("opening_angle", {0, 0.5, 1.5}, "", Applies::Live, "of Barnes-Hut: larger is faster and less exact, 0 is exact"),
            boolean("collide", false, Applies::Live, "let planets and suns collide"),
            boolean("follow", false, Applies::Live, "keep the nearest sun in the middle of the picture"),
            boolean("trails", true, Applies::Live, "draw where planets have been, for up to 2000 planets"),
        }),
        .make = [](const SceneSetup& setup) -> std::unique_ptr<Scene> { return std::make_unique<Planets>(setup); },
        .own_code = "planets that are lost are taken away",
    };
}

} // namespace carom::scenes
