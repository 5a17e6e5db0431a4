// A scene file as a scene: it can be drawn, measured and filmed as the named ones can.
#pragma once

#include "lab/scene_file/painting.hpp"
#include "scene_file/player.hpp"
#include "scenes/painted_scene.hpp"

#include <string>

namespace carom::lab
{

/// What a FileScene is made of, so that it is there before the scene itself.
struct FileSceneParts
{
    SceneFile file;
    std::string source; ///< name of the file, for messages
    scenes::SceneInfo scene_info;
};

class FileScene : private FileSceneParts, public scenes::PaintedScene
{
public:
    /// @param source name of the file, for messages
    /// @param values of its parameters
    /// @param own_parameters those from which the file was made; here they are only reported
    /// @throws SceneFileError when something in the file does not hold
    /// @throws SceneError on a parameter that does not exist or a value that does not fit
    FileScene(SceneFile file, std::string source, const scenes::ParameterValues& values = {},
              const std::vector<scenes::ParameterInfo>& own_parameters = {});

    const SceneFile& scene_file() const { return file; }
    /// The scene's parameters, controls and words.
    static scenes::SceneInfo info_of(const SceneFile& file, const std::vector<scenes::ParameterInfo>& own_parameters = {});

private:
    void before_step() override;
    void after_step(const StepReport& report) override;
    void on_draw(scenes::DrawList& list) const override;
    std::string status() const override;
    float step_length() const override;

    FilePlayback playback_;
    FilePainting painting_;
    float file_rate_; ///< the parameter step_rate that stands for the file's own time step [1/s]
    int next_step_ = 0;
    RayResult rays_;
};

} // namespace carom::lab
