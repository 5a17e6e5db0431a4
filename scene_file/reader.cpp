// Leads the JSON parser's events into the readers of values.
#include "scene_file/reader.hpp"

#include "scene_file/check.hpp"
#include "scene_file/object_readers.hpp"

#include <nlohmann/json.hpp>
#include <utility>

namespace carom::scene_file
{

using nlohmann::json;

namespace
{

constexpr std::size_t most_nested = 64;                 // of what is passed over; what is read is as deep as the fields are
constexpr std::size_t most_bytes_passed_over = 1 << 20; // behind one mistake

/// Thrown when enough problems are known.
struct Enough
{
};

/// The syntax error of the library's "[json.exception.parse_error.101] parse error at line 3, column 5: syntax error ...".
std::string without_place(std::string_view message)
{
    const std::size_t column = message.find(", column ");
    const std::size_t colon = message.find(": ", column == std::string_view::npos ? 0 : column);
    return shortened(colon == std::string_view::npos ? message : message.substr(colon + 2));
}

/// Takes the events of the parser. Each returns true: go on.
class Events
{
public:
    Events(TextInput& input, SceneFile& file, std::vector<SceneProblem>& problems, int most)
        : input_(input),
          file_(file),
          problems_(problems),
          most_(static_cast<std::size_t>(most)),
          reading_(input.name(), file.world)
    {
    }

    bool null() { return take({}); }
    bool boolean(bool value) { return take({.kind = Scalar::Kind::Bool, .number = value ? 1.0 : 0.0}); }
    bool number_integer(std::int64_t value)
    {
        return take({.kind = Scalar::Kind::Whole,
                     .number = static_cast<double>(value),
                     .bits = static_cast<std::uint64_t>(value),
                     .is_negative = value < 0});
    }
    bool number_unsigned(std::uint64_t value)
    {
        return take({.kind = Scalar::Kind::Whole, .number = static_cast<double>(value), .bits = value});
    }
    bool number_float(double value, const std::string& text) { return take({.kind = Scalar::Kind::Number, .number = value, .text = text}); }
    bool string(std::string& text) { return take({.kind = Scalar::Kind::Text, .text = text}); }
    bool binary(json::binary_t&) { return true; } // JSON has none
    bool start_object(std::size_t) { return begin(false); }
    bool start_array(std::size_t) { return begin(true); }
    bool end_object() { return end(); }
    bool end_array() { return end(); }
    bool key(std::string& key);
    bool parse_error(std::size_t, const std::string& token, const json::exception& error);

private:
    bool take(const Scalar& value);
    bool begin(bool is_list);
    bool end();
    Slot next_slot();
    template <class Action>
    void attempt(const Action& action);
    bool is_passed_over() const { return !reading_.frames.empty() && !reading_.frames.back().slot.reader; }
    bool pass_over() const;

    TextInput& input_;
    SceneFile& file_;
    std::vector<SceneProblem>& problems_;
    std::size_t most_;
    Reading reading_;
    std::size_t passed_over_from_ = 0; ///< bytes that were read when the parser came into what is passed over
};

/// Keeps a problem and goes on, unless it is the last one that is asked for.
template <class Action>
void Events::attempt(const Action& action)
{
    try
    {
        action();
    }
    catch (const SceneFileError& error)
    {
        problems_.push_back(error.problem());
        for (Frame& frame : reading_.frames) frame.has_problem = true;
        if (problems_.size() >= most_) throw Enough();
    }
}

/// Where the value goes that begins now.
Slot Events::next_slot()
{
    if (reading_.frames.empty()) return slot_of(file_, about(""));
    Frame& frame = reading_.frames.back();
    if (frame.is_list) ++frame.count;
    if (!frame.slot.reader) return {};
    if (!frame.is_list) return frame.next;
    try
    {
        return frame.slot.reader->element(reading_, frame);
    }
    catch (const SceneFileError&)
    {
        frame.slot = {}; // so would all that follow be refused
        passed_over_from_ = input_.bytes();
        throw;
    }
}

/// Lets a value go by, unless it is too far from the mistake for a reader to see both.
bool Events::pass_over() const
{
    if (input_.bytes() - passed_over_from_ > most_bytes_passed_over || reading_.frames.size() > most_nested) throw Enough();
    return true;
}

bool Events::take(const Scalar& value)
{
    if (is_passed_over()) return pass_over();
    reading_.place = input_.value_start();
    attempt([&]
    {
        const Slot slot = next_slot();
        if (slot.reader) slot.reader->read(reading_, slot, value);
    });
    return true;
}

bool Events::begin(bool is_list)
{
    Frame frame{.is_list = is_list, .start = input_.last()};
    if (is_passed_over())
        pass_over();
    else
    {
        reading_.place = frame.start;
        attempt([&]
        {
            Slot slot = next_slot();
            if (!slot.reader) return;
            slot = slot.reader->opened(slot);
            slot.reader->begin(reading_, slot, is_list);
            frame.slot = slot;
        });
        if (!frame.slot.reader) passed_over_from_ = input_.bytes();
    }
    reading_.frames.push_back(std::move(frame));
    return true;
}

bool Events::key(std::string& key)
{
    if (is_passed_over()) return pass_over();
    Frame& frame = reading_.frames.back();
    frame.key = key;
    frame.next = {};
    reading_.place = input_.value_start();
    attempt([&] { frame.next = frame.slot.reader->field(reading_, frame); });
    return true;
}

bool Events::end()
{
    Frame& frame = reading_.frames.back();
    if (frame.slot.reader) attempt([&] { frame.slot.reader->end(reading_, frame); });
    reading_.frames.pop_back();
    return true;
}

bool Events::parse_error(std::size_t, const std::string& token, const json::exception& error)
{
    constexpr int number_overflow = 406;
    if (error.id == number_overflow)
        take({.kind = Scalar::Kind::Number, .number = std::numeric_limits<double>::infinity(), .text = token});
    else
    {
        const Place place = input_.has_ended() ? input_.next_place() : input_.last();
        problems_.push_back({.source = input_.name(), .line = place.line, .column = place.column, .message = without_place(error.what())});
    }
    return false;
}

} // namespace

ReadResult read(TextInput& input, int most)
{
    ReadResult result;
    Events events(input, result.file, result.problems, most);
    try
    {
        json::sax_parse(TextIterator(input), TextIterator(), &events);
    }
    catch (const Enough&)
    {
    }
    catch (const SceneFileError& error) // of the input
    {
        result.problems.push_back(error.problem());
    }
    return result;
}

SceneFile read_checked(TextInput& input)
{
    ReadResult result = read(input, 1);
    if (!result.problems.empty()) throw SceneFileError(std::move(result.problems.front()));
    check(result.file, input.name());
    return std::move(result.file);
}

SceneFile read_scene_file(const std::filesystem::path& path)
{
    TextInput input(file_source(path), path.string());
    return read_checked(input);
}

SceneFile parse_scene_file(std::string_view text, const std::string& name)
{
    TextInput input(text_source(text), name);
    return read_checked(input);
}

} // namespace carom::scene_file
