// A step in pictures: what the world looked like at its start and after each of its stages.
#pragma once

#include <carom/carom.hpp>

#include <string>
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

/// How the world stands between two stages.
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

/// Records a step.
class StepFilm : public StepProbe
{
public:
    /// @param world as it is before the step
    explicit StepFilm(const World& world);

    void after_stage(const StepMoment& when, const StepView& view) override;

    const std::vector<FilmShape>& shapes() const { return shapes_; }
    const std::vector<Moment>& moments() const { return moments_; }
    std::uint64_t step() const { return step_; } ///< counted from 1

private:
    std::uint64_t step_;
    std::vector<FilmShape> shapes_;
    std::vector<Moment> moments_;
};

/// "solve, substep 2 of 4".
std::string title_of(const Moment& moment);
/// What the stage does, for someone who sees it for the first time.
std::string explanation_of(const Moment& moment);
/// What there is to count: "31 pairs, 4 of them new".
std::string counts_of(const Moment& moment);

} // namespace carom::gallery
