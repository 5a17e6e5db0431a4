// Ctrl-C and its like: noted, so that a run can end by itself and take its unfinished files away.
#pragma once

namespace carom::cli
{

/// From now on the first SIGINT, SIGTERM or SIGHUP is noted, and the same one again ends the process at once.
/// What is ignored, as under nohup, stays ignored.
void note_interruptions();

/// The signal that was noted last; 0 when there was none.
int interruption();

} // namespace carom::cli
