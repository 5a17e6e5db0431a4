// Where a scene comes from: from the named ones, from those of the laboratory, or from a file.
#pragma once

#include "lab/scene_file/model.hpp"
#include "scenes/scene.hpp"

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace carom::cli
{

class SceneSource
{
public:
    /// @param name a name that ends in .json or holds a slash is a file
    /// @throws scenes::SceneError when there is no such scene
    /// @throws lab::SceneFileError when the file can't be read
    static SceneSource find(const std::string& name);

    const scenes::SceneInfo& info() const { return *info_; }
    /// How long the scene is meant to run; empty when it goes on for as long as one likes.
    std::optional<int> steps() const { return steps_; }
    /// Whether a seed changes anything.
    bool has_seed() const { return kind_ != Kind::File; }

    /// @throws scenes::SceneError, lab::SceneFileError
    std::unique_ptr<scenes::Scene> make(const scenes::ParameterValues& values, std::uint64_t seed) const;
    /// @throws scenes::SceneError, lab::SceneFileError
    lab::SceneFile scene_file(const scenes::ParameterValues& values, std::uint64_t seed) const;

private:
    enum class Kind
    {
        Named,
        Laboratory,
        File
    };
    Kind kind_ = Kind::Named;
    std::string name_;
    std::shared_ptr<const scenes::SceneInfo> info_;
    std::shared_ptr<const lab::SceneFile> file_; ///< of a file
    std::optional<int> steps_;
};

} // namespace carom::cli
