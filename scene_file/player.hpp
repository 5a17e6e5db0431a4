// Plays scene files: builds the world, and does what is to happen before each step.
#pragma once

#include "scene_file/model.hpp"

#include <carom/carom.hpp>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace carom::scene_file
{

/// What the rays of a scene met in one step.
struct RayResult
{
    int hits = 0;
    double sum_of_fractions = 0; ///< of those that hit: a check that two engines met the same
};

/// What a scene file asks for, done to a world that someone else steps. The file and the name must outlive it.
class FilePlayback
{
public:
    /// @param name of the file, for messages
    FilePlayback(const SceneFile& file, const std::string& name) : file_(file), name_(name) {}

    /// A definition of the world without its memory and broad phase.
    static WorldDef world_def(const SceneFile& file);

    /// Makes what is there at the start, in a world that is made from world_def() and is empty.
    /// @throws SceneFileError when the engine refuses it, as a density for which a mass is too large
    void begin(World& world);
    /// Adds the gravity fields alone; begin() does it too.
    void add_fields(World& world);
    /// Makes the bodies and joints of the start alone; begin() does it too.
    void create_parts(World& world);
    /// Makes happen what belongs before a step. Steps are asked for in their order. Changes of what is gone are left out.
    void before_step(World& world, int step);
    /// Casts the scene's rays.
    RayResult cast_rays(const World& world);

    BodyId body(int number) const { return bodies_[static_cast<std::size_t>(number)]; }   ///< stale when it was destroyed
    JointId joint(int number) const { return joints_[static_cast<std::size_t>(number)]; } ///< stale when it was destroyed or broke
    int body_count() const { return static_cast<int>(bodies_.size()); }                   ///< made so far
    int joint_count() const { return static_cast<int>(joints_.size()); }                  ///< made so far
    const std::vector<BodyId>& bodies() const { return bodies_; }                         ///< by number
    const std::vector<JointId>& joints() const { return joints_; }                        ///< by number
    const SceneNames& names() const { return names_; }                                    ///< of what was made so far
    const std::vector<FieldId>& fields() const { return fields_; }                        ///< that add_fields() has added
    /// Whether before_step() has something to do.
    bool is_due(int step) const { return has_events_left() && file_.events[next_event_].step <= step; }
    bool has_events_left() const { return next_event_ < file_.events.size(); }

private:
    void create_bodies(World& world, const std::vector<FileBody>& bodies, const std::string& list);
    void put_to_sleep(World& world, const std::vector<FileBody>& bodies, std::size_t first_number) const;
    void create_joints(World& world, const std::vector<FileJoint>& joints, const std::string& list);
    void play(World& world, const FileEvent& event, const std::string& path);
    void destroy(World& world, const FileEvent& event);
    void set(World& world, const SetBody& set) const;
    void set(World& world, const SetJoint& set) const;
    template <class Path, class Action>
    void located(const Place& place, const Path& path, const Action& action) const;
    void add_shapes(World& world, BodyId id, const FileBody& body, const std::string& list, std::size_t index);

    const SceneFile& file_;
    const std::string& name_;
    std::vector<BodyId> bodies_;  ///< by number
    std::vector<JointId> joints_; ///< by number
    std::vector<FieldId> fields_;
    SceneNames names_;
    std::size_t next_event_ = 0;
    std::vector<std::optional<RayHit>> hits_;
};

/// A world that lives by a scene file. Equal files give equal hashes at every step.
class FilePlayer
{
public:
    /// @param name of the file, for messages
    /// @throws SceneFileError when something in the file does not hold
    explicit FilePlayer(SceneFile file, std::string name = "scene file");
    FilePlayer(const FilePlayer&) = delete;
    FilePlayer& operator=(const FilePlayer&) = delete;

    /// Does what belongs before the step, steps, and casts the rays.
    StepReport step();

    const SceneFile& file() const { return file_; }
    World& world() { return world_; }
    const World& world() const { return world_; }
    const FilePlayback& playback() const { return playback_; }
    const RayResult& rays() const { return rays_; } ///< of the last step

private:
    std::string name_;
    SceneFile file_;
    World world_;
    FilePlayback playback_;
    int next_step_ = 0;
    RayResult rays_;
};

} // namespace carom::scene_file
