#include "lab/engines.hpp"

#include <fstream>
#include <gtest/gtest.h>
#include <stdexcept>
#include <unistd.h>

namespace carom::lab
{

TEST(Engines, are_found_or_reported_as_missing)
{
    const std::filesystem::path folder = std::filesystem::path(testing::TempDir()) / ("carom_engines_test_" + std::to_string(getpid()));
    std::filesystem::create_directories(folder);
    std::ofstream(folder / "carom-peer-rapier") << "#!/bin/sh\n";
    const std::vector<std::string> names = {"rapier", "carom", "box2d3", "origin"};
    const std::vector<Engine> engines = find_engines(names, "/bin/carom", folder);
    ASSERT_EQ(engines.size(), 4u);
    EXPECT_EQ(engines[0].command.size(), 1u);
    EXPECT_EQ(engines[1].command, (std::vector<std::string>{"/bin/carom", "lab", "step"}));
    EXPECT_TRUE(engines[2].command.empty());
    EXPECT_NE(engines[2].missing.find("./dev peers"), std::string::npos);
    EXPECT_EQ(engines[3].command, (std::vector<std::string>{"/bin/carom", "lab", "step", "--broadphase", "Quadtree"}));
    std::filesystem::remove_all(folder);
}

TEST(Engines, take_part_by_default_but_a_checkout_only_where_it_is_built)
{
    const std::filesystem::path folder = std::filesystem::path(testing::TempDir()) / ("carom_engines_default_" + std::to_string(getpid()));
    std::filesystem::create_directories(folder);
    EXPECT_EQ(default_engines(folder), (std::vector<std::string>{"carom", "box2d3", "rapier", "box2d2", "origin"}));
    const std::vector<std::string> names = {"box2d3-source"};
    EXPECT_NE(find_engines(names, "/bin/carom", folder)[0].missing.find("./dev peers box2d3 --source DIR"), std::string::npos);
    std::ofstream(folder / "carom-peer-box2d3-source") << "#!/bin/sh\n";
    EXPECT_EQ(default_engines(folder), (std::vector<std::string>{"carom", "box2d3", "box2d3-source", "rapier", "box2d2", "origin"}));
    std::filesystem::remove_all(folder);
}

TEST(Engines, of_other_names_are_refused)
{
    const std::vector<std::string> names = {"chipmunk"};
    EXPECT_THROW(find_engines(names, "carom", "."), std::invalid_argument);
}

} // namespace carom::lab
