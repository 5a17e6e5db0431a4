#include "gallery/step_film.hpp"

#include <algorithm>
#include <gtest/gtest.h>
#include <set>

namespace carom::gallery
{

namespace
{

/// A ball that falls on a ground.
struct Fall
{
    Fall()
    {
        world.create_body({.type = BodyType::Static}, box(50, 1));
        world.create_body({.position = {0, 0.99f}}, circle(0.5f));
    }

    StepFilm film(std::size_t most, int substeps)
    {
        StepFilm film(world, most);
        world.step(1 / 60.0f, substeps, &film);
        return film;
    }

    World world{{.gravity = {0, -10}}};
};

std::set<int> substeps_of(const StepFilm& film)
{
    std::set<int> substeps;
    for (const Moment& moment : film.moments()) substeps.insert(moment.when.substep);
    return substeps;
}

} // namespace

TEST(StepFilm, holds_what_each_stage_is_about)
{
    for (const StepFilm film = Fall().film(1'000'000, 4); const Moment& moment : film.moments())
    {
        EXPECT_EQ(moment.poses.size(), 2u);
        if (moment.is_start) continue;
        const Stage stage = moment.when.stage;
        EXPECT_EQ(moment.pairs.size(), stage == Stage::FindPairs ? 1u : 0u) << name_of(stage);
        const bool is_solving =
            stage == Stage::WarmStart || stage == Stage::Solve || stage == Stage::Relax || stage == Stage::StoreImpulses;
        const bool is_about_contacts =
            is_solving || stage == Stage::UpdateManifolds || stage == Stage::BuildRows || stage == Stage::EmitEvents;
        EXPECT_EQ(moment.contacts.size(), is_about_contacts ? 1u : 0u) << name_of(stage);
    }
}

TEST(StepFilm, leaves_later_substeps_out_when_there_is_no_room)
{
    const StepFilm whole = Fall().film(1'000'000, 8);
    EXPECT_FALSE(whole.is_cut());
    EXPECT_EQ(whole.substeps_kept(), 8);
    EXPECT_EQ(whole.moments().size(), 1u + 4 + 5u * 8 + 5);

    const StepFilm half = Fall().film(whole.bytes() / 2, 8);
    EXPECT_TRUE(half.is_cut());
    EXPECT_GT(half.substeps_kept(), 1);
    EXPECT_LT(half.substeps_kept(), 8);
    EXPECT_EQ(half.moments().size(), 1u + 4 + 5u * static_cast<std::size_t>(half.substeps_kept()) + 5) << "each is there as a whole";
    EXPECT_EQ(half.moments().back().when.stage, Stage::Sleep);
    EXPECT_LT(half.bytes(), whole.bytes());

    const StepFilm least = Fall().film(0, 8);
    EXPECT_EQ(substeps_of(least), (std::set<int>{-1, 0}));
}

} // namespace carom::gallery
