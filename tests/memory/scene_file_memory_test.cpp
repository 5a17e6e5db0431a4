// What no scene holds is refused before it is read or stored, however long it is.
#include "tests/memory/counting_heap.hpp"

#include <carom/scene_file.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <istream>
#include <streambuf>
#include <string>

namespace carom
{

namespace
{

constexpr std::size_t megabyte = 1'000'000;

/// A text that is made as it is read: a start, then a piece over and over, up to a length.
class LongText : public std::streambuf
{
public:
    LongText(std::string start, std::string piece, std::size_t length) : next_(std::move(start)), piece_(std::move(piece)), left_(length) {}

    std::size_t characters_read() const { return read_; }

private:
    std::streamsize xsgetn(char* to, std::streamsize count) override
    {
        const std::size_t wanted = std::min(static_cast<std::size_t>(count), left_);
        while (next_.size() < wanted) next_ += piece_;
        next_.copy(to, wanted);
        next_.erase(0, wanted);
        left_ -= wanted;
        read_ += wanted;
        return static_cast<std::streamsize>(wanted);
    }

    std::string next_;
    std::string piece_;
    std::size_t left_;
    std::size_t read_ = 0;
};

struct Refusal
{
    std::string problem;
    std::size_t characters = 0;
    std::size_t bytes = 0; ///< from the heap at a time
};

/// @param action is given the stream and returns the problem
template <class Action>
Refusal refusal_of(LongText text, const Action& action)
{
    std::istream stream(&text);
    watch_heap_peak();
    const std::size_t before = heap_bytes();
    Refusal refusal{.problem = action(stream)};
    refusal.characters = text.characters_read();
    refusal.bytes = heap_peak() - before;
    return refusal;
}

Refusal refusal_to_load(const std::string& start, const std::string& piece, std::size_t length)
{
    World world;
    return refusal_of({start, piece, length}, [&](std::istream& stream) { return load_scene(world, stream).problem.text(); });
}

} // namespace

TEST(SceneFileMemory, a_list_of_200_MB_is_refused_at_its_first_character)
{
    const Refusal refusal = refusal_to_load("[1", ",1", 200 * megabyte);
    EXPECT_EQ(refusal.problem, "scene:1:1: the file is a list; write {\"carom_scene\": 1, ...}");
    EXPECT_LT(refusal.characters, megabyte);
    EXPECT_LT(refusal.bytes, megabyte);
}

TEST(SceneFileMemory, a_list_of_200_MB_in_the_place_of_another_value_is_refused_at_its_first_character)
{
    const Refusal refusal = refusal_to_load("{\"carom_scene\": 1, \"steps\": [1", ",1", 200 * megabyte);
    EXPECT_EQ(refusal.problem, "scene:1:29: steps is a list; give a whole number from 1 to 1e+07");
    EXPECT_LT(refusal.characters, megabyte);
    EXPECT_LT(refusal.bytes, megabyte);
}

TEST(SceneFileMemory, a_name_of_100_MB_is_refused_at_its_limit)
{
    const Refusal refusal = refusal_to_load("{\"carom_scene\": 1, \"bodies\": [{\"name\": \"", "name", 100 * megabyte);
    EXPECT_EQ(refusal.problem, "scene:1:40: a text is longer than 64 KiB; make it shorter");
    EXPECT_LT(refusal.characters, megabyte);
    EXPECT_LT(refusal.bytes, 4 * megabyte);
}

TEST(SceneFileMemory, a_key_and_a_number_of_100_MB_are_refused_at_their_limits)
{
    EXPECT_LT(refusal_to_load("{\"", "key", 100 * megabyte).bytes, 4 * megabyte);
    const Refusal refusal = refusal_to_load("{\"carom_scene\": 1, \"steps\": 1", "0", 100 * megabyte);
    EXPECT_EQ(refusal.problem, "scene:1:29: a number or word is longer than 1024 characters; make it shorter");
    EXPECT_LT(refusal.characters, megabyte);
    EXPECT_LT(refusal.bytes, megabyte);
}

TEST(SceneFileMemory, what_is_passed_over_while_all_problems_are_listed_is_not_kept)
{
    const Refusal refusal = refusal_of({"{\"carom_scene\": 1, \"steps\": [[1", ",1", 200 * megabyte},
                                       [](std::istream& stream) { return validate_scene(stream).at(0).text(); });
    EXPECT_EQ(refusal.problem, "scene:1:29: steps is a list; give a whole number from 1 to 1e+07");
    EXPECT_LT(refusal.characters, 2 * megabyte);
    EXPECT_LT(refusal.bytes, megabyte);
}

TEST(SceneFileMemory, spaces_take_none)
{
    World world;
    LongText text("{\"carom_scene\": 1, \"bodies\": [{}]}", " \n", 20 * megabyte);
    std::istream stream(&text);
    watch_heap_peak();
    const std::size_t before = heap_bytes();
    EXPECT_TRUE(load_scene(world, stream));
    EXPECT_EQ(text.characters_read(), 20 * megabyte);
    EXPECT_LT(heap_peak() - before, megabyte);
}

} // namespace carom
