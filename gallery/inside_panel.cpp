// The way through a step, stage by stage.
#include "gallery/moment_words.hpp"
#include "gallery/panels.hpp"
#include "gallery/widgets.hpp"

#include <cstdio>

namespace carom::gallery
{

namespace
{

void walk_buttons(Gallery& gallery)
{
    Session& session = gallery.session;
    if (button(gallery, "< Back", "the moment before (left arrow)")) session.previous_moment();
    flow("Next >");
    if (button(gallery, "Next >", "the next moment; after the last one, the next step (right arrow)")) session.next_moment();
    const float slider_width = 14 * ImGui::GetFontSize();
    flow(slider_width);
    auto index = static_cast<int>(session.moment());
    const int last = static_cast<int>(session.film().moments().size()) - 1;
    ImGui::PushItemWidth(slider_width);
    if (slider("##moment", index, 0, last, "moment %d")) session.show_moment(static_cast<std::size_t>(index));
    gallery.widgets.note("moment");
    ImGui::PopItemWidth();
    flow("Leave");
    if (button(gallery, "Leave", "I or Esc")) session.leave_inside();
}

} // namespace

void inside_panel(Gallery& gallery)
{
    walk_buttons(gallery);
    if (!gallery.session.is_inside()) return; // it was left
    const StepFilm& film = gallery.session.film();
    const Moment& moment = film.moments()[gallery.session.moment()];
    char step[48];
    std::snprintf(step, sizeof step, "Step %llu: ", static_cast<unsigned long long>(film.step()));
    ImGui::TextUnformatted((step + title_of(moment)).c_str());
    const std::string counts = counts_of(moment);
    flow(counts.c_str());
    muted(counts);
    ImGui::PushTextWrapPos(0);
    ImGui::TextUnformatted(explanation_of(moment).c_str());
    ImGui::PopTextWrapPos();
    if (film.is_cut())
        muted("The world is so large that only the first " + std::to_string(film.substeps_kept()) + " of " +
              std::to_string(film.moments().back().when.substeps) + " substeps were kept.");
}

} // namespace carom::gallery
