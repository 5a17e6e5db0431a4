// Arguments for random calls, good and bad, and what a call with them must do.
//
// The limits are written down here a second time, from the public headers, so that a check that the engine lacks, or one that it makes
// too strict, shows.
#pragma once

#include "tests/fuzz/random.hpp"

#include <carom/carom.hpp>

#include <array>
#include <limits>
#include <optional>
#include <vector>

namespace carom::fuzz
{

inline constexpr float inf = std::numeric_limits<float>::infinity();
inline constexpr float nan = std::numeric_limits<float>::quiet_NaN();
inline constexpr std::array nasty = {nan,
                                     inf,
                                     -inf,
                                     0.0f,
                                     -0.0f,
                                     -1.0f,
                                     1e30f,
                                     -1e30f,
                                     1e-30f,
                                     1e-40f,
                                     1e7f,
                                     1e6f,
                                     std::numeric_limits<float>::max(),
                                     std::numeric_limits<float>::lowest()};

/// Values from `least` to `most` are good.
struct Limits
{
    float least;
    float most;
};

inline constexpr Limits finite = {std::numeric_limits<float>::lowest(), std::numeric_limits<float>::max()};
inline constexpr Limits coordinate = {-max_coordinate, max_coordinate};
inline constexpr Limits speed = {-max_speed, max_speed};
inline constexpr Limits factor = {-1e6f, 1e6f};
inline constexpr Limits rate = {0, 1e6f};
inline constexpr Limits share = {0, 1};
inline constexpr Limits force = {0, 1e20f};
inline constexpr Limits strength = {-1e20f, 1e20f};
inline constexpr Limits radius = {1e-6f, max_coordinate}; // below a nanometre a circle has no mass, and none is drawn in between

/// What a call must do.
enum class Verdict
{
    Accept,
    Refuse,
    Either ///< the limit is too fine to be told here
};

/// Draws arguments and judges them as it goes.
class RandomArguments
{
public:
    explicit RandomArguments(std::uint64_t seed) : random(seed) {}

    Random random;

    /// For all that was drawn since forget(): one bad argument is enough to be refused.
    Verdict verdict() const { return is_bad_ ? Verdict::Refuse : is_doubtful_ ? Verdict::Either : Verdict::Accept; }
    void forget() { is_bad_ = is_doubtful_ = false; }
    void expect(bool is_good) { is_bad_ = is_bad_ || !is_good; }
    void doubt(bool is_doubtful = true) { is_doubtful_ = is_doubtful_ || is_doubtful; }

    float unjudged(float min, float max); ///< now and then a nasty one
    float number(float min, float max, Limits good);
    Vec2 vector(float size, Limits good = coordinate);
    template <class Enum>
    Enum one_of(int count, int one_bad_in)
    {
        if (!random.one_in(one_bad_in)) return static_cast<Enum>(random.below(count));
        is_bad_ = true;
        return static_cast<Enum>(random.one_in(2) ? count : -1);
    }
    Transform transform();

    /// @throws UsageError when it is made by a maker and that refuses
    Geometry geometry();
    bool is_by_hand() const { return is_by_hand_; } ///< the last geometry has not been through a maker, and so is not checked yet
    Geometry circle_by_hand();
    Geometry capsule_by_hand(float size = 2);
    float capsule_radius(float min, float max);
    Material material();
    BodyDef body_def();
    ShapeDef shape_def(const Geometry& geometry);
    /// Judges whether the engine can compute with the mass.
    void judge_density(const Geometry& geometry, float density);
    QueryFilter query_filter(BodyId ignored);
    Field field();
    JointSpec joint_spec();
    Transform frame();
    void judge_frame(const Transform& frame);
    float break_limit(float min, float max);

private:
    Geometry rounded();
    Geometry offset();
    Geometry polygon_by_hand();
    Geometry hull();
    void judge_ends(Vec2 p1, Vec2 p2);
    std::optional<Spring> maybe_spring();
    Spring spring();
    std::optional<Range> maybe_range(Limits good);
    std::optional<Motor> maybe_motor();

    bool is_bad_ = false;
    bool is_doubtful_ = false;
    bool is_by_hand_ = false;
};

} // namespace carom::fuzz
