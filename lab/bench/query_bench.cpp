// Rays, casts and overlaps in a field of shapes at rest: Carom, and Box2D 3 where the build was given a checkout of it.
#include <carom/carom.hpp>

#if defined(CAROM_BENCH_BOX2D)
#include <box2d/box2d.h>
#endif

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <optional>
#include <random>
#include <vector>

namespace
{

constexpr int query_count = 10'000;
constexpr float cast_radius = 0.3f; // [m]

struct Placed
{
    carom::Vec2 position;
    float angle;
    float size; ///< width of a box, diameter of a circle [m]
    bool is_circle;
    bool is_static; ///< or kinematic, which lies in the tree of what moves
};

/// What both engines are asked.
struct Field
{
    std::vector<Placed> shapes;
    std::vector<carom::Ray> rays;
};

Field make_field(int count, float side, float ray_length)
{
    std::mt19937 engine(1);
    const auto uniform = [&engine](float low, float high)
    { return low + (high - low) * static_cast<float>(engine() >> 8) / static_cast<float>(1 << 24); };
    Field field;
    for (int i = 0; i < count; ++i)
    {
        const float x = uniform(0, side);
        const float y = uniform(0, side);
        const float angle = uniform(-carom::pi, carom::pi);
        field.shapes.push_back({{x, y}, angle, uniform(0.3f, 0.9f), i % 2 == 1, i % 4 < 2});
    }
    for (int i = 0; i < query_count; ++i)
    {
        const float x = uniform(0, side);
        const float y = uniform(0, side);
        const carom::SinCos v = carom::sin_cos(uniform(-carom::pi, carom::pi));
        field.rays.push_back({{x, y}, ray_length * carom::Vec2{v.cos, v.sin}});
    }
    return field;
}

class CaromField
{
public:
    explicit CaromField(const Field& field) : rays_(field.rays), hits_(field.rays.size())
    {
        for (const Placed& p : field.shapes)
        {
            const carom::BodyType type = p.is_static ? carom::BodyType::Static : carom::BodyType::Kinematic;
            const carom::Geometry geometry =
                p.is_circle ? carom::Geometry(carom::circle(p.size / 2)) : carom::Geometry(carom::box(p.size, p.size));
            world_.create_body({.type = type, .position = p.position, .angle = p.angle}, geometry);
        }
        world_.step(1 / 60.0f);
    }

    // Each tells how much it found.
    long rays()
    {
        world_.cast_rays(rays_, hits_);
        return std::count_if(hits_.begin(), hits_.end(), [](const auto& hit) { return hit.has_value(); });
    }
    long circle_casts()
    {
        long found = 0;
        for (const carom::Ray& ray : rays_) found += world_.cast_circle(ray.start, cast_radius, ray.sweep).has_value();
        return found;
    }
    long boxes(float half)
    {
        long found = 0;
        const carom::Vec2 corner{half, half};
        for (const carom::Ray& ray : rays_)
            world_.visit_overlapping(carom::Aabb{ray.start - corner, ray.start + corner}, [&found](carom::ShapeId) { ++found; });
        return found;
    }
    long circles(float radius)
    {
        long found = 0;
        const carom::Geometry circle = carom::circle(radius);
        for (const carom::Ray& ray : rays_) world_.visit_overlapping(circle, {ray.start, {}}, [&found](carom::ShapeId) { ++found; });
        return found;
    }

private:
    carom::World world_{{.gravity = {}}};
    const std::vector<carom::Ray>& rays_;
    std::vector<std::optional<carom::RayHit>> hits_;
};

#if defined(CAROM_BENCH_BOX2D)

b2Vec2 vec2(carom::Vec2 v) { return {v.x, v.y}; }

class Box2dField
{
public:
    explicit Box2dField(const Field& field) : rays_(field.rays)
    {
        b2WorldDef def = b2DefaultWorldDef();
        def.gravity = {0, 0};
        world_ = b2CreateWorld(&def);
        for (const Placed& p : field.shapes)
        {
            b2BodyDef body = b2DefaultBodyDef();
            body.type = p.is_static ? b2_staticBody : b2_kinematicBody;
            body.position = vec2(p.position);
            body.rotation = b2MakeRot(p.angle);
            const b2BodyId id = b2CreateBody(world_, &body);
            const b2ShapeDef shape = b2DefaultShapeDef();
            const b2Circle circle = {{0, 0}, p.size / 2};
            const b2Polygon box = b2MakeBox(p.size / 2, p.size / 2);
            if (p.is_circle)
                b2CreateCircleShape(id, &shape, &circle);
            else
                b2CreatePolygonShape(id, &shape, &box);
        }
        b2World_Step(world_, 1 / 60.0f, 4);
        b2World_RebuildStaticTree(world_);
    }
    Box2dField(const Box2dField&) = delete;
    Box2dField& operator=(const Box2dField&) = delete;
    ~Box2dField() { b2DestroyWorld(world_); }

    long rays()
    {
        long found = 0;
        for (const carom::Ray& ray : rays_) found += b2World_CastRayClosest(world_, vec2(ray.start), vec2(ray.sweep), filter_).hit;
        return found;
    }
    long circle_casts()
    {
        long found = 0;
        const auto nearest = [](b2ShapeId, b2Vec2, b2Vec2, float fraction, void* met) { return *static_cast<bool*>(met) = true, fraction; };
        const b2Vec2 middle = {0, 0};
        const b2ShapeProxy circle = b2MakeProxy(&middle, 1, cast_radius);
        for (const carom::Ray& ray : rays_)
        {
            bool met = false;
            b2World_CastShape(world_, vec2(ray.start), &circle, vec2(ray.sweep), filter_, nearest, &met);
            found += met;
        }
        return found;
    }
    long boxes(float half)
    {
        long found = 0;
        for (const carom::Ray& ray : rays_)
            b2World_OverlapAABB(world_, vec2(ray.start), {{-half, -half}, {half, half}}, filter_, count, &found);
        return found;
    }
    long circles(float radius)
    {
        long found = 0;
        const b2Vec2 middle = {0, 0};
        const b2ShapeProxy circle = b2MakeProxy(&middle, 1, radius);
        for (const carom::Ray& ray : rays_) b2World_OverlapShape(world_, vec2(ray.start), &circle, filter_, count, &found);
        return found;
    }

private:
    static bool count(b2ShapeId, void* found) { return ++*static_cast<long*>(found), true; }

    b2WorldId world_ = b2_nullWorldId;
    b2QueryFilter filter_ = b2DefaultQueryFilter();
    const std::vector<carom::Ray>& rays_;
};

#endif

struct Measured
{
    double us = 1e30; ///< a query, the shortest of several rounds
    long found = 0;

    template <class Work>
    void run(Work&& work)
    {
        const auto start = std::chrono::steady_clock::now();
        found = work();
        us = std::min(us, std::chrono::duration<double, std::micro>(std::chrono::steady_clock::now() - start).count() / query_count);
    }
};

/// Rounds in turns, so that what the machine does hits both.
template <class Work, class... Fields>
void measure(const char* name, Work work, Fields&... fields)
{
    Measured results[sizeof...(fields)];
    for (int round = 0; round < 9; ++round)
    {
        std::size_t at = 0;
        (results[at++].run([&] { return work(fields); }), ...);
    }
    std::printf("  %-22s", name);
    for (const Measured& r : results) std::printf(" %9.3f us, %7ld found", r.us, r.found);
    if (sizeof...(fields) > 1) std::printf("   %.2f x", results[sizeof...(fields) - 1].us / results[0].us);
    std::printf("\n");
}

template <class... Fields>
void measure_all(Fields&... fields)
{
    measure("rays", [](auto& field) { return field.rays(); }, fields...);
    measure("circle casts", [](auto& field) { return field.circle_casts(); }, fields...);
    for (const float size : {0.5f, 3.0f, 12.0f})
    {
        char name[32];
        std::snprintf(name, sizeof name, "boxes of %g m", static_cast<double>(2 * size));
        measure(name, [size](auto& field) { return field.boxes(size); }, fields...);
        std::snprintf(name, sizeof name, "circles of %g m", static_cast<double>(2 * size));
        measure(name, [size](auto& field) { return field.circles(size); }, fields...);
    }
}

} // namespace

int main()
{
    struct Size
    {
        int shapes;
        float side;       ///< [m]
        float ray_length; ///< [m]
    };
    for (const Size& size : {Size{1000, 90, 20}, Size{20'000, 400, 30}})
    {
        const Field field = make_field(size.shapes, size.side, size.ray_length);
        CaromField carom(field);
#if defined(CAROM_BENCH_BOX2D)
        const b2Version version = b2GetVersion();
        std::printf("%d shapes: carom, box2d %d.%d.%d, and how many times faster carom is\n", size.shapes, version.major, version.minor,
                    version.revision);
        Box2dField box2d(field);
        measure_all(carom, box2d);
#else
        std::printf("%d shapes: carom\n", size.shapes);
        measure_all(carom);
#endif
    }
}
