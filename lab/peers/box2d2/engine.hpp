// A world of Box2D 2.4 that lives by a scene file. Bodies and joints go by their numbers in the file.
#pragma once

#include "lab/engine_run.hpp"
#include "lab/scene_file/model.hpp"

#include <box2d/box2d.h>

#include <optional>
#include <string>
#include <vector>

namespace carom::lab::box2d2
{

/// What its users take: the engine divides no step, and iterates instead.
inline constexpr int velocity_iterations = 8;
inline constexpr int position_iterations = 3;

/// Something in the scene that the engine can't do; what() names it.
class Lacking : public std::runtime_error
{
public:
    using std::runtime_error::runtime_error;
};

/// @throws Lacking naming all that the scene needs and the engine lacks
void require_features(const SceneFile& file);
/// What is not as the file asks, in plain words.
std::vector<std::string> differences(const SceneFile& file, int threads);

/// Mixes the properties of two surfaces where the file asks for other rules than the engine's own, or for conveyors.
class Surfaces final : public b2ContactListener
{
public:
    explicit Surfaces(const MaterialMixing& mixing) : mixing_(mixing) {}
    void BeginContact(b2Contact* contact) override;

private:
    MaterialMixing mixing_;
};

class Engine
{
public:
    explicit Engine(const SceneFile& file);

    void before_step(int step); ///< what the file's events ask for; steps come in their order
    void step();                ///< the engine's own step, and nothing else
    void break_joints();        ///< destroys what the step overstrained: the engine leaves that to its users
    int cast_rays() const;      ///< how many meet something
    std::vector<std::optional<BodySample>> bodies() const;

private:
    struct JointPlace
    {
        const FileJoint* made_as;
        b2Joint* joint; ///< null when it is gone
    };

    void create(const std::vector<FileBody>& bodies, const std::vector<FileJoint>& joints);
    void make_joint(std::size_t number, const JointSpec& spec, b2Body& a, b2Body& b);
    void create_body(const FileBody& body);
    void create_shape(b2Body& body, const FileShape& shape);
    void create_chain(b2Body& body, const FileChain& chain);
    void add_fixture(b2Body& body, const b2Shape& shape, const Material& material, const ShapeDef& def);
    void play(const FileEvent& event);
    void destroy_body(int number);
    void set(const SetBody& set);
    void set(const SetJoint& set);
    b2Body& body(int number) { return *bodies_[static_cast<std::size_t>(number)]; }

    const SceneFile& file_;
    b2World world_;
    Surfaces surfaces_;
    b2Body* ground_ = nullptr;       ///< what joints to the world hold to
    std::vector<b2Body*> bodies_;    ///< by number; null when destroyed
    std::vector<JointPlace> joints_; ///< by number
    std::size_t next_event_ = 0;
    bool has_breakable_joints_ = false;
};

b2Vec2 vec2(Vec2 v);

} // namespace carom::lab::box2d2
