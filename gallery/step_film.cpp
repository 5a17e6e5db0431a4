// Records what each stage is about, and nothing else: a large world has much to show, and a step has many moments.
#include "gallery/step_film.hpp"

namespace carom::gallery
{

namespace
{

/// Writes down what a walk shows.
class Recorder : public DebugDraw
{
public:
    Recorder(Moment& moment, std::vector<FilmShape>* shapes) : moment_(moment), shapes_(shapes) {}

    void shape(ShapeId id, BodyId body, const Geometry& geometry, const Transform& transform) override
    {
        moment_.poses.push_back(transform);
        if (shapes_) shapes_->push_back({id, body, geometry});
    }
    void body(const DebugBody& body) override { moment_.bodies.push_back(body); }
    void pair(ShapeId a, ShapeId b, bool is_new) override { moment_.pairs.push_back({a, b, is_new}); }
    void contact(const DebugContact& contact) override { moment_.contacts.push_back(contact); }
    void joint(const DebugJoint& joint) override { moment_.joints.push_back(joint); }

private:
    Moment& moment_;
    std::vector<FilmShape>* shapes_;
};

DrawPart parts_of(Stage stage)
{
    switch (stage)
    {
    case Stage::FindPairs: return DrawPart::Shapes | DrawPart::Pairs;
    case Stage::UpdateManifolds:
    case Stage::EmitEvents: return DrawPart::Shapes | DrawPart::Contacts;
    case Stage::BuildRows: return DrawPart::Shapes | DrawPart::Bodies | DrawPart::Contacts;
    case Stage::WarmStart:
    case Stage::Solve:
    case Stage::Relax:
    case Stage::StoreImpulses: return DrawPart::Shapes | DrawPart::Bodies | DrawPart::Contacts | DrawPart::Joints;
    case Stage::Restitution:
    case Stage::IntegrateVelocities:
    case Stage::IntegratePositions:
    case Stage::FinalizeBodies:
    case Stage::Continuous:
    case Stage::Sleep: break;
    }
    return DrawPart::Shapes | DrawPart::Bodies;
}

template <class Thing>
std::size_t bytes_of(const std::vector<Thing>& things)
{
    return things.capacity() * sizeof(Thing);
}

std::size_t bytes_of(const Moment& m)
{
    return sizeof m + bytes_of(m.poses) + bytes_of(m.bodies) + bytes_of(m.pairs) + bytes_of(m.contacts) + bytes_of(m.joints);
}

} // namespace

StepFilm::StepFilm(const World& world, std::size_t most) : step_(world.step_count() + 1), most_(most)
{
    Moment& start = moments_.emplace_back();
    start.is_start = true;
    Recorder recorder(start, &shapes_);
    world.debug_draw(recorder, DrawPart::Shapes | DrawPart::Bodies);
    for (FilmShape& shape : shapes_) shape.is_dynamic = world.body(shape.body).type() == BodyType::Dynamic;
    bytes_ = bytes_of(start);
}

void StepFilm::after_stage(const StepMoment& when, const StepView& view)
{
    const bool is_next_substep = when.substep >= substeps_kept_;
    if (is_next_substep && when.substep > 0 && bytes_ > most_) is_cut_ = true;
    if (when.substep >= 0 && is_cut_) return;
    if (is_next_substep) ++substeps_kept_;
    Moment& moment = moments_.emplace_back();
    moment.when = when;
    moment.poses.reserve(shapes_.size());
    Recorder recorder(moment, nullptr);
    view.debug_draw(recorder, parts_of(when.stage));
    bytes_ += bytes_of(moment);
}

} // namespace carom::gallery
