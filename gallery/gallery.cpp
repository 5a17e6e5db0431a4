// What belongs to no single part: where the camera looks, and whom it follows.
#include "gallery/gallery.hpp"

#include <utility>

namespace carom::gallery
{

void Gallery::toggle_follow()
{
    const BodyId body = inspected();
    const bool can_follow = !session.watched() && session.scene().world().find_body(body);
    session.watch(can_follow ? body : BodyId{});
}

void Gallery::look(scenes::Viewport window, const Rect& free)
{
    const std::string& scene = session.source().info().name;
    const bool is_new = std::exchange(generation_, session.generation()) != session.generation();
    // The camera of another scene says nothing here, nor where a body was that is gone with its world.
    if (std::exchange(scene_, scene) != scene || (is_new && view.is_following())) view.reset();
    const std::optional<Vec2> place = session.watched_place();
    if (!place) session.watch({});
    view.set_layout(window, free);
    view.set_base(session.scene().camera());
    view.follow(place);
}

} // namespace carom::gallery
