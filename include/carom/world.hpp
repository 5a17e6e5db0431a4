// The world: makes bodies and shapes, steps them, and tells what happened.
#pragma once

#include <carom/body.hpp>
#include <carom/broad_phase.hpp>
#include <carom/chain.hpp>
#include <carom/debug_draw.hpp>
#include <carom/error.hpp>
#include <carom/events.hpp>
#include <carom/fields.hpp>
#include <carom/hooks.hpp>
#include <carom/joint.hpp>
#include <carom/queries.hpp>
#include <carom/report.hpp>
#include <carom/shape.hpp>
#include <carom/simd.hpp>
#include <carom/step_probe.hpp>

#include <cstdint>
#include <memory>
#include <memory_resource>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace carom
{

/// Constants of the solver. The defaults suit bodies of 0.1 to 10 length units (WorldDef::length_unit), which the speeds are counted in.
struct SolverTuning
{
    float contact_hertz = 30;         ///< stiffness of contacts, also limited to an eighth of the substep rate [1/s], >= 0.01
    float contact_damping_ratio = 10; ///< >= 0
    float push_out_speed = 3;         ///< most speed at which overlap is undone [length units/s], >= 0.0001
    float restitution_threshold = 1;  ///< slower approaches do not bounce [length units/s], >= 0
    float joint_hertz = 60;           ///< how fast joints undo their errors, also limited to a quarter of the substep rate [1/s], >= 0.01
    float joint_damping_ratio = 2;    ///< >= 0
    /// The impulses of a step are the first guess of the next. Without that, tall piles sink in and long chains stretch: for experiments.
    bool warm_starting = true;

    friend bool operator==(const SolverTuning&, const SolverTuning&) = default;
};

/// When bodies at rest leave the simulation. Bodies that touch or are joined sleep and wake together. A sleeping body costs
/// nothing; sensors and queries see it. A contact, a joint, a force, a change or a teleport wakes it. No body sleeps while an
/// N-body field exists.
///
/// A body is at rest while no point of it is faster than `speed`, and as long as no point of it has drifted by more than a tenth of
/// the body's outer radius since it became that slow; then the time counts anew. The outer radius reaches from the centre of mass to
/// the farthest point of a shape. So a body that falls asleep has drifted by at most `speed` times `time`, 2.5 cm with the defaults,
/// and by at most a tenth of its outer radius.
///
/// A drive that moves its bodies keeps them awake, however slowly: a surface with a tangent_speed, a joint's motor, a MotorJoint
/// or MouseJoint on the way to its target, a kinematic body with a velocity. A drive that is blocked (it reaches less than a
/// hundredth of the speed that it asks for) does not.
struct SleepTuning
{
    bool is_enabled = true;
    float speed = 0.05f; ///< a body that is faster is not at rest [length units/s], >= 0
    float time = 0.5f;   ///< how long a body must be at rest before it falls asleep [s], >= 0

    friend bool operator==(const SleepTuning&, const SleepTuning&) = default;
};

/// Room to set aside at the start, so that a world without joints, with the default broad phase, need not grow while it runs.
struct CapacityHints
{
    int bodies = 0;
    int shapes = 0;
    int contacts = 0;
};

struct WorldDef
{
    Vec2 gravity = {0, -9.81f}; ///< [m/s^2]
    /// Typical size of a body [m], 0.001 to 1000. Every tolerance of the engine is a share of it: how deep bodies may sink in, how near is
    /// touching, the least size of a shape. Keep 1 for bodies of 0.1 m to 10 m; give 0.01 for a world of small parts, 100 for one of ships.
    /// It changes no other unit: lengths stay metres. Speeds of SolverTuning, SleepTuning and hit_speed are counted in length units a second.
    float length_unit = 1;
    Simd simd = Simd::Best; ///< the instruction set of the solver, which does not show in the results
    BroadPhaseType broad_phase = BroadPhaseType::Tree;
    BroadPhaseOptions broad_phase_options = {};
    SolverTuning solver = {};
    SleepTuning sleep = {};
    bool continuous = true; ///< fast bodies are stopped at what they would pass through
    MaterialMixing mixing = {};
    float hit_speed = 1; ///< slower collisions make no ContactHit [length units/s], 0 to 1e6
    /// Most pairs of near shapes (StepReport::pairs), 0 to 2^30. A guard against bodies that are put into one place by mistake, where n of
    /// them are n (n - 1) / 2 pairs: a step that would find more throws UsageError, which names the place, and leaves the world as it was.
    /// 0 allows 64 for each shape, and 524,288 in any case. A pair takes about 1 KB.
    int max_pairs = 0;
    bool stage_times = true; ///< whether StepReport tells seconds: some tens of readings of the clock, a microsecond a step
    CapacityHints capacity = {};
    ContactHooks* hooks = nullptr; ///< must outlive the world's last step and edit, or be replaced before; null for none
    /// Where every byte that the world holds comes from; null is the default resource. Must outlive the world.
    std::pmr::memory_resource* memory = nullptr;
};

/// A simulation. Worlds know nothing of each other; one world is used by one thread at a time. Every call that changes a world
/// throws UsageError on a bad argument, and then nothing has changed. So it is when the memory resource throws in a call that
/// creates a body, a shape, a chain or a field. A step that the memory resource stops leaves a world that can be read and destroyed; changing it throws
/// UsageError, and so does querying it. Lengths are in metres, masses in kilograms, times in
/// seconds, angles in radians.
class World
{
    struct Defaults;

public:
    explicit World(const WorldDef& def = {});
    /// `World({})` is `World()`. Without this constructor it would be ambiguous with moving from an empty world.
    explicit World(Defaults*) : World(WorldDef{}) {}
    ~World();
    World(World&&) noexcept;
    World& operator=(World&&) noexcept;

    // Bodies and shapes.
    BodyId create_body(const BodyDef& def);
    /// A body with one shape.
    BodyId create_body(const BodyDef& def, const Geometry& geometry, const ShapeDef& shape = {});
    void destroy_body(BodyId id); ///< and its shapes
    ShapeId create_shape(BodyId body, const Geometry& geometry, const ShapeDef& def = {});
    void destroy_shape(ShapeId id); ///< not a chain's segment: those go all together
    ChainId create_chain(BodyId body, const ChainDef& def);
    void destroy_chain(ChainId id); ///< and its segments

    Body body(BodyId id); ///< throws UsageError on a stale id
    BodyView body(BodyId id) const;
    std::optional<Body> find_body(BodyId id); ///< empty on a stale or null id
    std::optional<BodyView> find_body(BodyId id) const;
    Shape shape(ShapeId id);
    ShapeView shape(ShapeId id) const;
    std::optional<Shape> find_shape(ShapeId id);
    std::optional<ShapeView> find_shape(ShapeId id) const;
    Chain chain(ChainId id);
    ChainView chain(ChainId id) const;
    std::optional<Chain> find_chain(ChainId id);
    std::optional<ChainView> find_chain(ChainId id) const;
    std::vector<BodyId> bodies() const; ///< ordered by index

    // Joints.
    /// @throws UsageError when a body is stale, both are the same, or a value is out of range
    JointId create_joint(const JointDef& def, const JointSpec& spec);
    void destroy_joint(JointId id);
    /// A definition whose frames meet at a point of the world, with their x axes along `axis` [rad].
    JointDef joint_at(BodyId a, BodyId b, Vec2 point, float axis = 0) const;
    /// A definition whose frames lie at two points of the world, with their x axes from the first to the second.
    JointDef joint_between(BodyId a, BodyId b, Vec2 point_a, Vec2 point_b) const;
    /// The motor joint that holds the frames of `def` as they stand now: offset [m] of frame B in frame A, and its angle [rad].
    /// @throws UsageError when a body is stale, both are the same, or a value is out of range
    MotorJoint motor_joint_as_placed(const JointDef& def) const;
    Joint joint(JointId id); ///< throws UsageError on a stale id
    JointView joint(JointId id) const;
    std::optional<Joint> find_joint(JointId id); ///< empty on a stale or null id
    std::optional<JointView> find_joint(JointId id) const;
    std::vector<JointId> joints() const; ///< ordered by index
    std::vector<JointId> joints_of(BodyId body) const;

    // Gravity.
    Vec2 gravity() const;
    void set_gravity(Vec2 gravity);
    FieldId add_field(const Field& field);
    void set_field(FieldId id, const Field& field);
    void remove_field(FieldId id);
    Field field(FieldId id) const;       ///< throws UsageError on a stale id
    std::vector<FieldId> fields() const; ///< ordered by index
    /// Acceleration that gravity and fields give to a body of gravity scale 1 at a point [m/s^2], pull by every source included.
    Vec2 gravity_at(Vec2 point) const;

    // Time.
    /// Advances the world.
    ///
    /// How long a step may be: contacts are springs, as stiff as SolverTuning::contact_hertz asks, but at most an eighth of the
    /// substep rate, `substeps` / `dt`. Softer piles sink and tip over. With the defaults and boxes of one size, a tower of 5 stands
    /// from 60 substeps a second on, of 10 from 160, of 20 from 240. Whether they come from more steps or from more substeps hardly
    /// matters: 0.1 s needs 16 substeps for a tower of 10. StepReport::is_too_long warns.
    ///
    /// @param dt       [s], 0 or from 1e-6 to 1; 0 updates contacts and events, moves nothing and leaves forces for the next step
    /// @param substeps parts into which the step is divided, 1 to 64; more make stiff piles and fast spins more exact
    /// @param probe    called at the end of each stage, to look inside the step; null for none
    /// @throws UsageError also when there would be more pairs than WorldDef::max_pairs; then nothing has moved, and events are cleared. Make room, or
    ///         raise the limit, and step on.
    StepReport step(float dt, int substeps = 4, StepProbe* probe = nullptr);
    /// What happened in the last step.
    Events events() const;
    /// The contact points between two shapes as of the last step, its normal from `a` to `b`; no points when they are apart. Impulses
    /// are those on `b`.
    Manifold manifold(ShapeId a, ShapeId b) const;

    // Queries. All see the bodies where they are now, whatever was edited since the last step. Their results depend neither on the broad phase nor
    // on the order in which it looks; what is equally near is ordered by the shape's index. Several threads may query one world at once as long as
    // nobody changes or steps it. During a step they throw UsageError, and so they do on a point or a shape that is not finite or beyond
    // max_coordinate, on a sweep longer than twice that along an axis, and in a world whose memory resource failed during a step. Points and
    // sweeps are in metres.

    /// The first shape that a ray meets; see CastHit for rays that start inside of one or on its surface.
    std::optional<RayHit> cast_ray(Vec2 start, Vec2 sweep, const QueryFilter& filter = {}) const;
    /// True when the ray meets anything: cheaper than to ask for the first.
    bool is_ray_blocked(Vec2 start, Vec2 sweep, const QueryFilter& filter = {}) const;
    /// Every shape that the ray meets, where it enters it, ordered by fraction and then by index.
    std::vector<RayHit> cast_ray_all(Vec2 start, Vec2 sweep, const QueryFilter& filter = {}) const;
    /// Many rays at once.
    /// @param hits as many as rays: each gets what cast_ray would return
    void cast_rays(std::span<const Ray> rays, std::span<std::optional<RayHit>> hits, const QueryFilter& filter = {}) const;

    /// The first shape that a shape meets when it moves along `sweep` without turning.
    /// @param start the frame of `geometry` at the start; q a unit rotation
    std::optional<CastHit> cast_shape(const Geometry& geometry, const Transform& start, Vec2 sweep, const QueryFilter& filter = {}) const;
    /// @param radius from 1 mm, times the length unit, to max_coordinate [m]
    std::optional<CastHit> cast_circle(Vec2 center, float radius, Vec2 sweep, const QueryFilter& filter = {}) const;
    /// Every shape that it meets, ordered by fraction and then by index.
    std::vector<CastHit> cast_shape_all(const Geometry& geometry, const Transform& start, Vec2 sweep, const QueryFilter& filter = {}) const;

    /// The shapes whose bounds share a point with the box, ordered by index. Quick and coarse: their outlines may lie outside.
    std::vector<ShapeId> overlapping(const Aabb& box, const QueryFilter& filter = {}) const;
    /// The shapes that overlap a shape, or are within 5 um (times the length unit) of it, ordered by index.
    std::vector<ShapeId> overlapping(const Geometry& geometry, const Transform& transform, const QueryFilter& filter = {}) const;
    /// The shapes in which a point lies, or on whose edge, ordered by index. A segment holds no point but those that lie on it exactly.
    std::vector<ShapeId> shapes_at(Vec2 point, const QueryFilter& filter = {}) const;
    // The same, shape by shape and without allocating. The visitor must not change the world.
    void visit_overlapping(const Aabb& box, ShapeVisitor visit, const QueryFilter& filter = {}) const;
    void visit_overlapping(const Geometry& geometry, const Transform& transform, ShapeVisitor visit, const QueryFilter& filter = {}) const;
    void visit_shapes_at(Vec2 point, ShapeVisitor visit, const QueryFilter& filter = {}) const;

    /// The nearest point of any shape, as far as max_distance [m], 0 to 4 max_coordinate.
    std::optional<NearestPoint> closest_point(Vec2 point, float max_distance, const QueryFilter& filter = {}) const;

    /// Pushes what is around; see ExplosionDef.
    /// @return number of shapes that were pushed
    int explode(const ExplosionDef& def);

    // The broad phase.
    BroadPhaseType broad_phase() const;
    BroadPhaseOptions broad_phase_options() const;
    /// Changes how pairs are found, and nothing else: the world goes on to the same bits.
    void set_broad_phase(BroadPhaseType type, const BroadPhaseOptions& options = {});

    // The instruction set.
    Simd simd() const; ///< the one that is used: never Simd::Best
    /// Changes how fast steps are, and nothing else.
    /// @throws UsageError when this machine does not have it, and when CAROM_SIMD in the environment names none that it has
    void set_simd(Simd simd);

    float length_unit() const; ///< as the world was made [m]

    SolverTuning solver_tuning() const;
    void set_solver_tuning(const SolverTuning& tuning);

    SleepTuning sleep_tuning() const;
    void set_sleep_tuning(const SleepTuning& tuning); ///< wakes all when it forbids sleep
    void wake_all();
    bool is_continuous() const;
    void set_continuous(bool continuous);

    MaterialMixing mixing() const;
    void set_mixing(const MaterialMixing& mixing); ///< also for contacts that exist; wakes all
    float hit_speed() const;                       ///< [length units/s]
    void set_hit_speed(float speed);               ///< [length units/s], 0 to 1e6
    int max_pairs() const;                         ///< as it was set: 0 when the world chooses
    void set_max_pairs(int count);                 ///< 0 to 2^30; for the steps to come
    ContactHooks* hooks() const;
    /// Surfaces of contacts that exist mix anew; pairs that are together stay so, and sleepers sleep on. The hooks must outlive
    /// the world's last step and edit, or be replaced before; null for none.
    void set_hooks(ContactHooks* hooks);

    int body_count() const;
    int awake_body_count() const; ///< dynamic and kinematic ones that take part in the next step
    int shape_count() const;
    int joint_count() const;
    /// What the world holds now, by category. The total is what its memory resource has given and not got back.
    MemoryReport memory() const;
    /// Gives memory that is not in use back to the world's memory resource: after a level has been unloaded, say. Bodies, shapes,
    /// contacts and joints that exist stay where they are; what lies behind the last one of a kind goes, as does spare room. So a
    /// world with few bodies becomes small when they are its oldest, and an empty one as small as a new one.
    /// Costs about as much as copying the world, and needs some memory while it works; should the memory resource fail, the world
    /// can be read and destroyed only.
    ///
    /// No body moves, and the next steps give the same motion. Ids that name something still do, and ids of what was destroyed stay
    /// stale. The lists of the last step's events are emptied. The next calls and steps may allocate again, which a warm world does
    /// not. What is created later may get other ids than without this call; hash() covers which, so that it changes when places
    /// behind the last one in use were given back. Programs that compare hashes shrink their worlds at the same step.
    /// @throws UsageError during a step
    void shrink();
    /// Number of steps taken.
    std::uint64_t step_count() const;
    /// A hash of the whole state. Equal runs give equal hashes at every step, whatever the broad phase, compiler or build type.
    std::uint64_t hash() const;
    /// Shows what the world holds to a visitor, as of the last step and the edits since.
    /// @param parts what to walk
    /// @throws UsageError when `parts` has bits that are no part
    void debug_draw(DebugDraw& visitor, DrawPart parts = DrawPart::All) const;

    // Copies.
    /// A world of its own that goes on to the same bits as this one. Its ids carry a number of its own; translated() gives them. Events of the last
    /// step and hooks are not copied.
    /// @param memory where the copy's memory comes from; null is this world's resource
    World copy(std::pmr::memory_resource* memory = nullptr) const;
    /// Becomes what `saved` is, a copy that was made of this world before, or any other world: rollback. This world keeps its number, so that ids
    /// from before the copy name the same things again. Needs no memory when the world was as large before.
    void restore(const World& saved);
    /// The id by which this world knows what `id` names in a world that this one was copied from, or was copied from this one.
    template <class Tag>
    Id<Tag> translated(Id<Tag> id) const
    {
        return id ? Id<Tag>{id.index, id.generation, number()} : id;
    }
    /// What the ids of this world carry.
    std::uint32_t number() const;

private:
    friend class Character;
    /// @throws UsageError in the name of `function` once the world was moved from
    detail::WorldState& state(std::string_view function) const;

    struct Destroy
    {
        void operator()(detail::WorldState*) const;
    };
    std::unique_ptr<detail::WorldState, Destroy> state_;
};

} // namespace carom
