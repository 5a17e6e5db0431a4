// Random calls to a world, good and bad, with every promise about them checked as they are made.
#pragma once

#include "tests/fuzz/random_arguments.hpp"
#include "tests/fuzz/random_hooks.hpp"

#include <carom/carom.hpp>

#include <cstdint>
#include <optional>
#include <set>
#include <vector>

namespace carom::fuzz
{

/// How the calls of a run ended.
struct Tally
{
    int calls = 0;
    int refused = 0;     ///< threw UsageError
    int doubtful = 0;    ///< where either was right
    int stale = 0;       ///< of those refused, on a view or an id of what was gone
    int during_step = 0; ///< of those refused, from inside a step
    int quarantined = 0; ///< bodies that steps reported
    int most_bodies = 0;
    int most_chains = 0;
    int hook_calls = 0;
    int probe_refused = 0; ///< edits from inside of a probe
    int most_joints = 0;
    int breaks = 0; ///< joints that steps broke
};

void report_accepted(const char* function);
void report_refused(const UsageError& error);

/// Makes random calls to one world.
class RandomApi
{
public:
    explicit RandomApi(std::uint64_t seed);

    /// Makes one call. Failed promises are reported through GoogleTest.
    void call();
    Tally tally() const;

private:
    // Now and then stale, null or of another world; a call with such a one must be refused.
    BodyId body_id();
    ShapeId shape_id();
    FieldId field_id();
    ChainId chain_id();
    JointId joint_id();
    BodyId any_body();  ///< the same, where any is good
    BodyId gone_body(); ///< null when there is none; so are the next
    ShapeId gone_shape();
    ChainId gone_chain();
    JointId gone_joint();

    /// Makes a call whose arguments are drawn as it is made. It must be refused when one of them is bad, and then change nothing, and must
    /// be accepted when all are good.
    /// @return whether it was accepted
    template <class Call>
    bool try_call(const char* function, Call&& call);
    /// A call that is wrong beyond doubt.
    template <class Call>
    void must_refuse(const char* function, Call&& call);
    void remember_state(); ///< to compare with, unless it is known
    void expect_unchanged(const UsageError& error) const;
    void forget_state() { is_state_known_ = false; } ///< something was changed

    // Bodies, shapes and chains.
    void create();
    std::optional<Geometry> made_geometry();
    void create_body(const Geometry& geometry);
    void create_shape(const Geometry& geometry);
    void destroy();
    void edit_body();
    void edit_flags(Body body);
    void push_body();
    void edit_shape();
    void make_chain();
    void edit_chain();

    // Joints, rules, fields and steps.
    void create_joint();
    JointDef joint_def();
    void edit_joint();
    void edit_rules();
    void edit_world();
    void step();
    void check_step(const StepReport& report, float dt, const std::set<BodyId>& endless);

    // Reading.
    void read();
    void query();
    void measure();
    void cast();
    void walk();

    // What must always be refused.
    void call_stale_view();
    void call_stale_id();
    void make_mistake();
    void edit_during_step();
    void refuse_during_step(); ///< called from inside a step

    RandomArguments draw_;
    Hook hook_;
    RandomHooks hooks_;
    World world_;
    World other_;
    BodyId foreign_;
    std::vector<BodyId> bodies_; ///< stale ones stay in
    std::vector<ShapeId> shapes_;
    std::vector<FieldId> fields_; ///< without stale ones: a field can't be looked for
    std::vector<FieldId> gone_fields_;
    std::vector<ChainId> chains_;
    std::vector<JointId> joints_;
    std::vector<Body> body_views_; ///< some, to outlive what they show
    std::vector<Shape> shape_views_;
    std::vector<Chain> chain_views_;
    std::vector<Joint> joint_views_;
    std::set<BodyId> with_own_mass_; ///< set_mass_data was called
    Character character_;
    bool is_state_known_ = false;
    std::uint64_t hash_ = 0;
    std::optional<std::uint64_t> readable_; ///< as far as it was read
    Tally tally_;
};

template <class Call>
bool RandomApi::try_call(const char* function, Call&& call)
{
    ++tally_.calls;
    remember_state();
    bool is_accepted = false;
    try
    {
        call();
        is_accepted = true;
        if (draw_.verdict() == Verdict::Refuse) report_accepted(function);
        forget_state();
    }
    catch (const UsageError& error)
    {
        ++tally_.refused;
        expect_complete(error, function);
        expect_unchanged(error);
        if (draw_.verdict() == Verdict::Accept) report_refused(error);
    }
    tally_.doubtful += draw_.verdict() == Verdict::Either;
    draw_.forget();
    return is_accepted;
}

template <class Call>
void RandomApi::must_refuse(const char* function, Call&& call)
{
    draw_.expect(false);
    try_call(function, call);
}

} // namespace carom::fuzz
