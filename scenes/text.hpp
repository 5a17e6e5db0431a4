// Words for messages, for the scenes and what builds on them.
#pragma once

#include "support/text.hpp"

namespace carom::scenes
{

using support::closest;
using support::joined;
using support::lower_case;
using support::suggestion;

} // namespace carom::scenes
