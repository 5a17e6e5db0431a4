// Typed parameters of a scene: what may be set, to which values, and what is said when a value does not fit.
#pragma once

#include <cstdint>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace carom::scenes
{

/// A scene or parameter that does not exist, or a value that it does not take. Nothing has changed.
/// what() reads "circles: 30000 is out of range; give an integer from 0 to 20000".
class SceneError : public std::invalid_argument
{
public:
    SceneError(std::string subject, std::string problem, std::string remedy);

    const std::string& subject() const { return subject_; } ///< the parameter, or "scene"
    const std::string& problem() const { return problem_; } ///< names the value
    const std::string& remedy() const { return remedy_; }

private:
    std::string subject_;
    std::string problem_;
    std::string remedy_;
};

enum class ParameterKind
{
    Real,
    Integer,
    Boolean,
    Choice
};

/// "real", "integer", "boolean", "choice".
std::string_view name_of(ParameterKind kind);

enum class Applies
{
    Live,     ///< at once
    OnRestart ///< to the next scene that is made
};

/// A Boolean, Integer, Real or Choice.
using ParameterValue = std::variant<bool, std::int64_t, double, std::string>;
using ParameterValues = std::vector<std::pair<std::string, ParameterValue>>;

struct ParameterInfo
{
    std::string name;
    std::string description;
    std::string unit; ///< empty for a pure number, a Boolean and a choice
    ParameterKind kind = ParameterKind::Real;
    ParameterValue initial = 0.0;
    double min = 0;                   ///< of a number, included
    double max = 0;                   ///< of a number, included
    std::vector<std::string> choices; ///< of a choice
    Applies applies = Applies::OnRestart;
};

struct RealRange
{
    double min, initial, max;
};
struct IntegerRange
{
    std::int64_t min, initial, max;
};

ParameterInfo real(std::string name, RealRange range, std::string unit, Applies applies, std::string description);
ParameterInfo integer(std::string name, IntegerRange range, std::string unit, Applies applies, std::string description);
ParameterInfo boolean(std::string name, bool initial, Applies applies, std::string description);
/// @param choices the first is the default
ParameterInfo choice(std::string name, std::vector<std::string> choices, Applies applies, std::string description);

/// "an integer from 0 to 20000", "a number from 0 to 50 m/s", "true or false", "one of a, b, c".
std::string allowed_values(const ParameterInfo& info);
/// As a person writes it: "34", "0.5", "true", "Quadtree".
std::string to_text(const ParameterValue& value);
/// @return the value in the parameter's own kind; a choice in its own spelling, whatever the case
/// @throws SceneError when it is of another kind or out of range
ParameterValue checked(const ParameterInfo& info, const ParameterValue& value);
/// Reads what a person wrote.
/// @throws SceneError when it is not of the parameter's kind or is out of range
ParameterValue parsed(const ParameterInfo& info, std::string_view text);
/// Reads settings as a command line has them: "circles=500".
/// @throws SceneError on one without a name or a value, an unknown name, or a value that does not fit
ParameterValues parsed_settings(std::span<const ParameterInfo> infos, std::span<const std::string> settings);
/// @throws SceneError naming a parameter of a similar name, or all of them
const ParameterInfo& find_parameter(std::span<const ParameterInfo> infos, std::string_view name);

/// The values of a scene's parameters, always within their ranges.
class Parameters
{
public:
    /// All at their defaults.
    /// @param infos must outlive this
    explicit Parameters(std::span<const ParameterInfo> infos);

    std::span<const ParameterInfo> infos() const { return infos_; }
    /// @throws SceneError
    void set(std::string_view name, const ParameterValue& value);
    const ParameterValue& value(std::string_view name) const; ///< throws SceneError; so do the next four
    float real(std::string_view name) const { return static_cast<float>(std::get<double>(value(name))); }
    int integer(std::string_view name) const { return static_cast<int>(std::get<std::int64_t>(value(name))); }
    bool boolean(std::string_view name) const { return std::get<bool>(value(name)); }
    const std::string& choice(std::string_view name) const { return std::get<std::string>(value(name)); }
    /// All names and values, in order.
    ParameterValues values() const;

private:
    std::size_t index_of(std::string_view name) const;

    std::span<const ParameterInfo> infos_;
    std::vector<ParameterValue> values_;
};

} // namespace carom::scenes
