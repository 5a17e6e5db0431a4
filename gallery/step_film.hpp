// A step in pictures: what the world looked like at its start and after each of its stages.
#pragma once

#include <carom/carom.hpp>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace carom::gallery
{

struct FilmShape
{
    ShapeId id;
    BodyId body;
    Geometry geometry;
    bool is_dynamic = false;
};

struct FilmPair
{
    ShapeId shape_a;
    ShapeId shape_b;
    bool is_new = false;
};

/// How the world stands between two stages: where the shapes are, and what the stage is about.
struct Moment
{
    bool is_start = false; ///< before any stage; `when` then says nothing
    StepMoment when = {};
    std::vector<Transform> poses; ///< of the film's shapes, in their order
    std::vector<DebugBody> bodies;
    std::vector<FilmPair> pairs;
    std::vector<DebugContact> contacts;
    std::vector<DebugJoint> joints;
};

/// Records a step. When a step has more to show than there is room for, its later substeps are left out; the first one and what follows the last
/// are always there.
class StepFilm : public StepProbe
{
public:
    /// @param world as it is before the step
    /// @param most  memory after which no further substep is recorded [bytes]
    explicit StepFilm(const World& world, std::size_t most = 200'000'000);

    void after_stage(const StepMoment& when, const StepView& view) override;

    const std::vector<FilmShape>& shapes() const { return shapes_; }
    const std::vector<Moment>& moments() const { return moments_; }
    std::uint64_t step() const { return step_; }         ///< counted from 1
    std::size_t bytes() const { return bytes_; }         ///< of its moments
    bool is_cut() const { return is_cut_; }              ///< whether substeps were left out
    int substeps_kept() const { return substeps_kept_; } ///< from the first one on

private:
    std::uint64_t step_;
    std::size_t most_;
    std::size_t bytes_ = 0;
    int substeps_kept_ = 0;
    bool is_cut_ = false;
    std::vector<FilmShape> shapes_;
    std::vector<Moment> moments_;
};

} // namespace carom::gallery
