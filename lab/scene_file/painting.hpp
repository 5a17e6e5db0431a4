// What a world that lives by a scene file looks like.
#pragma once

#include "lab/scene_file/model.hpp"
#include "scene_file/player.hpp"
#include "scenes/camera.hpp"
#include "scenes/draw_list.hpp"
#include "scenes/helpers.hpp"

namespace carom::lab
{

/// Colours for the bodies of a file, by their numbers. The file must outlive it.
class FilePainting
{
public:
    explicit FilePainting(const SceneFile& file) : file_(file) {}

    /// Gives the bodies that are new their colours.
    void paint_new_bodies(const World& world, const FilePlayback& playback);
    /// Adds bodies, joints and rays.
    /// @param camera that of the picture: it bounds how large joints are drawn
    void draw(const World& world, const scenes::Camera& camera, scenes::DrawList& list) const;

    /// What the file asks to be shown, or else all that can move, or all that there is.
    static scenes::Camera camera_of(const SceneFile& file, const World& world);

private:
    const SceneFile& file_;
    scenes::PerShape<scenes::Color> colors_;
    int painted_ = 0; ///< bodies that have their colours
};

} // namespace carom::lab
