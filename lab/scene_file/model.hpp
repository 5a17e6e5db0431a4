// Scene files as the laboratory knows them: the parts of scene_file/ under its own name.
#pragma once

#include "scene_file/model.hpp"

namespace carom::lab
{

using namespace scene_file;

} // namespace carom::lab
