// What all scenes share: common parameters and keys, the order of a step, captions.
#include "scenes/scene.hpp"

#include "scenes/helpers.hpp"
#include "scenes/text.hpp"

#include <algorithm>
#include <cmath>

namespace carom::scenes
{

namespace
{

WorldDef with_broad_phase(WorldDef def, const Parameters& parameters)
{
    def.broad_phase = broad_phase_named(parameters.choice("broad_phase")).value();
    return def;
}

} // namespace

std::vector<std::string> broad_phase_names()
{
    std::vector<std::string> names;
    for (const BroadPhaseType type : all_broad_phases) names.emplace_back(name_of(type));
    return names;
}

std::vector<ParameterInfo> with_common_parameters(std::vector<ParameterInfo> own, BroadPhaseType broad_phase, int substeps)
{
    std::vector<std::string> names = broad_phase_names(); // the default comes first
    const auto initial = std::find(names.begin(), names.end(), name_of(broad_phase));
    std::rotate(names.begin(), initial, initial + 1);
    own.push_back(choice("broad_phase", names, Applies::Live, "how pairs of near shapes are found"));
    own.push_back(real("step_rate", {10, 60, 1000}, "1/s", Applies::Live, "steps in a second of simulated time"));
    own.push_back(integer("substeps", {1, substeps, 64}, "", Applies::Live, "parts into which the solver divides a step"));
    own.push_back(boolean("show_squares", broad_phase == BroadPhaseType::Quadtree, Applies::Live, "draw the broad phase's nodes"));
    own.push_back(boolean("show_bounds", false, Applies::Live, "draw the bounds of shapes"));
    return own;
}

std::vector<Control> with_common_controls(std::vector<Control> own)
{
    own.push_back({Control::Kind::Key, "q", "show or hide the broad phase's nodes"});
    own.push_back({Control::Kind::Key, "b", "show or hide the bounds of shapes"});
    return own;
}

Scene::Scene(const SceneSetup& setup, WorldDef world)
    : info_(setup.info),
      parameters_(setup.parameters),
      seed_(setup.seed),
      world_(with_broad_phase(world, setup.parameters))
{
}

void Scene::set_parameter(std::string_view name, const ParameterValue& value)
{
    const ParameterInfo& parameter = find_parameter(parameters_.infos(), name);
    parameters_.set(name, value);
    if (parameter.applies != Applies::Live) return;
    if (name == "broad_phase") world_.set_broad_phase(broad_phase_named(choice(name)).value());
    on_parameter(name);
}

void Scene::pointer(const PointerEvent& event)
{
    const bool is_near = std::abs(event.position.x) <= farthest_pointer && std::abs(event.position.y) <= farthest_pointer; // nor NaN
    if (is_near && std::isfinite(event.wheel)) on_pointer(event);
}

void Scene::key(std::string_view name)
{
    const std::string key = lower_case(name);
    if (key == "q") return toggle("show_squares");
    if (key == "b") return toggle("show_bounds");
    const auto is_it = [&](const Control& control) { return control.kind == Control::Kind::Key && control.input == key; };
    if (std::any_of(info_.controls.begin(), info_.controls.end(), is_it)) on_key(key);
}

std::optional<BodyId> Scene::add_guest(const BodyDef& def, const Geometry& geometry, const ShapeDef& shape)
{
    if (!may_add_at(def.position)) return std::nullopt;
    const BodyId body = world_.create_body(def, geometry, shape);
    guests_.push_back(body);
    return body;
}

StepReport Scene::step(StepObserver* observer, StepProbe* probe)
{
    before_step();
    const float dt = step_length();
    const int substeps = integer("substeps");
    if (observer) observer->world_step_begins();
    const StepReport report = world_.step(dt, substeps, probe);
    if (observer) observer->world_step_ended();
    time_ += static_cast<double>(dt);
    after_step(report);
    return report;
}

void Scene::draw(DrawList& list) const
{
    if (boolean("show_squares")) draw_broad_phase(world_, list);
    on_draw(list);
    draw_guests(list);
    if (boolean("show_bounds")) draw_bounds(world_, list);
    draw_captions(list);
}

void Scene::draw_guests(DrawList& list) const
{
    for (std::size_t i = 0; i < guests_.size(); ++i)
    {
        const std::optional<BodyView> body = world_.find_body(guests_[i]);
        if (!body) continue;
        constexpr float golden_ratio = 0.618034f; // hues that follow each other are far apart
        const Color color = from_hue(golden_ratio * static_cast<float>(i), 0.55f, 0.62f);
        for (const ShapeId shape : body->shapes())
            list.shape(Layer::Bodies, world_.shape(shape).geometry(), body->transform(), {.fill = color, .line = darker(color, 0.4f)});
    }
}

void Scene::draw_captions(DrawList& list) const
{
    list.text({.text = info_.title, .color = paper, .size = 24, .place = Place::TopLeft});
    const std::string words = status();
    if (!words.empty()) list.text({.text = words, .color = with_alpha(paper, 0.7f), .size = 17, .place = Place::TopLeft});
    if (time_ < message_until_) list.text({.text = message_, .color = rgb(1, 0.8f, 0.35f), .size = 20, .place = Place::BottomLeft});
}

bool Scene::may_add_at(Vec2 position)
{
    if (world_.body_count() >= max_bodies)
    {
        say("The scene is full: it holds " + std::to_string(world_.body_count()) + " bodies.");
        return false;
    }
    if (shape_at(world_, position))
    {
        say("A body is in the way there.");
        return false;
    }
    return true;
}

void Scene::say(std::string message)
{
    constexpr double seconds = 3;
    message_ = std::move(message);
    message_until_ = time_ + seconds;
}

} // namespace carom::scenes
