// Where each value of a scene file goes while the parser passes over it: straight into the fields of the model, never into a tree in memory. A value
// that does not fit is refused at its first character.
#pragma once

#include "scene_file/fields.hpp"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace carom::scene_file
{

class Reading;
class ValueReader;
struct Frame;

/// The place for one value: what reads it, and what it may be.
struct Slot
{
    const ValueReader* reader = nullptr; ///< null: the value is passed over
    void* value = nullptr;               ///< of the type that the reader is for
    Rule rule = about("");
};

/// Enough of a text to recognise it in a message, safe to print.
std::string shortened(std::string_view text);
/// A number as it would be written by hand.
std::string number_text(double value);

/// A value that is neither an object nor a list.
struct Scalar
{
    enum class Kind
    {
        Null,
        Bool,
        Whole,
        Number,
        Text
    };

    Kind kind = Kind::Null;
    double number = 0;          ///< of Bool, Whole and Number; infinite when it is too large for a double
    std::uint64_t bits = 0;     ///< of Whole: the value modulo 2^64
    bool is_negative = false;   ///< of Whole
    std::string_view text = ""; ///< of Text, without quotes; of Number, as it is written
    std::string shown() const;  ///< as it would stand in a file, shortened
};

/// An object or a list that the parser is in.
struct Frame
{
    Slot slot = {};
    bool is_list = false;
    bool has_problem = false; ///< something in it was refused: what follows from it is not looked at
    Place start = {};
    std::size_t count = 0;        ///< of a list: elements so far, the current one included
    std::string key = {};         ///< of an object: the current field
    Slot next = {};               ///< of an object: where the current field's value goes
    std::uint64_t seen = 0;       ///< of an object: a bit for each field that it has, by the order of Fields
    std::string_view choice = {}; ///< of an object: which alternative it has
};

/// Reads values of one type. The functions throw SceneFileError through Reading::fail.
class ValueReader
{
public:
    virtual ~ValueReader() = default;
    /// The slot of what is inside, for a type that may be null.
    virtual Slot opened(const Slot& slot) const { return slot; }
    virtual void read(Reading& reading, const Slot& slot, const Scalar& value) const;
    virtual void begin(Reading& reading, const Slot& slot, bool is_list) const;
    virtual Slot field(Reading& reading, Frame& frame) const;
    virtual Slot element(Reading& reading, Frame& frame) const;
    virtual void end(Reading& reading, Frame& frame) const;

protected:
    /// What is expected, "give a list in []".
    virtual std::string remedy(const Slot& slot) const = 0;
};

/// What is limited over the whole file, so that no file takes more memory than a large scene does.
struct Total
{
    std::size_t index;
    int most;
    const char* what;
};
inline constexpr std::size_t total_count = 6;

/// The state of reading one file: where the parser is and what it has counted.
class Reading
{
public:
    /// @param world of the file, as far as it was read
    Reading(std::string name, const FileWorld& world) : world_(world), name_(std::move(name)) {}

    std::vector<Frame> frames;
    Place place = {};           ///< of what is looked at
    PolygonFields polygon = {}; ///< of the polygon that is being read

    /// Of the world, as far as is known: it may come after the bodies [m].
    float length_unit() const { return world_.length_unit; }
    /// Adds an element to one of the lists whose lengths are limited in sum.
    void count(const Total& total);
    /// Refuses the value that is read.
    [[noreturn]] void fail(const std::string& problem, const std::string& remedy) const { fail_at(path(frames.size()), problem, remedy); }
    /// Refuses the object that the parser is in, at the field that is read.
    [[noreturn]] void fail_object(const std::string& problem, const std::string& remedy) const
    {
        fail_at(path(frames.size() - 1), problem, remedy);
    }
    /// Refuses the object or list that the parser is in, at its start, or a field of it.
    [[noreturn]] void fail_inside(const std::string& field, const std::string& problem, const std::string& remedy);
    /// "bodies[3].shapes[0]"
    std::string path(std::size_t depth) const;

private:
    [[noreturn]] void fail_at(std::string path, const std::string& problem, const std::string& remedy) const;

    const FileWorld& world_;
    std::string name_;
    std::size_t counts_[total_count] = {};
};

} // namespace carom::scene_file
