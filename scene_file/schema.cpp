// Walks the fields of each part and writes down what may stand in them.
#include "scene_file/schema.hpp"

#include "scene_file/check.hpp"
#include "scene_file/json_values.hpp"

namespace carom::scene_file
{

using nlohmann::ordered_json;

namespace
{

class SchemaWriter
{
public:
    std::string text()
    {
        ordered_json schema;
        schema["$schema"] = "https://json-schema.org/draft/2020-12/schema";
        schema["title"] = "Carom scene file";
        schema.update(object_schema<SceneFile>());
        schema["$defs"] = definitions_;
        return schema.dump(2) + "\n";
    }

    template <class T>
    ordered_json of(const T*, const Rule& rule)
    {
        if constexpr (std::is_same_v<T, bool>)
            return {{"type", "boolean"}};
        else if constexpr (std::is_same_v<T, std::string>)
            return {{"type", "string"}};
        else if constexpr (std::is_same_v<T, float>)
            return number(rule, "number");
        else if constexpr (std::is_integral_v<T>)
            return number(std::is_unsigned_v<T> ? Rule{.what = "", .min = 0, .max = 0x1p64} : rule, "integer");
        else if constexpr (std::is_enum_v<T>)
            return {{"enum", Words<T>::all}};
        else if constexpr (std::is_same_v<T, Vec2> || std::is_same_v<T, Rot>)
            return list(number(rule, "number"), 2, 2);
        else if constexpr (std::is_same_v<T, Polygon>)
            return reference<PolygonFields>();
        else if constexpr (std::is_same_v<T, Field>)
            return field_schema();
        else
            return reference<T>();
    }
    template <class T>
    ordered_json of(const std::optional<T>*, const Rule& rule)
    {
        return {{"anyOf", {of(static_cast<const T*>(nullptr), rule), ordered_json{{"type", "null"}}}}};
    }
    template <class T>
    ordered_json of(const std::vector<T>*, const Rule& rule)
    {
        Rule inner = about("");
        if (std::is_same_v<T, int>) inner = {.what = "", .min = 0, .max = rule.max - 1};
        if (std::is_same_v<T, Vec2>) inner = place("");
        return list(of(static_cast<const T*>(nullptr), inner), rule.min, rule.max);
    }

    /// Of an object with the fields of T and no others.
    template <class T>
    ordered_json object_schema();

private:
    static ordered_json end(double value)
    {
        const auto single = static_cast<float>(value);
        if (value == 0x1p64) return UINT64_MAX;
        return double{single} == value ? json_of(single) : ordered_json(value);
    }

    static ordered_json number(const Rule& rule, const char* type)
    {
        ordered_json schema = {{"type", type}};
        if (std::isfinite(rule.min)) schema[rule.is_above_min ? "exclusiveMinimum" : "minimum"] = end(rule.min);
        if (std::isfinite(rule.max)) schema["maximum"] = end(rule.max);
        return schema;
    }

    static ordered_json list(ordered_json items, double least, double most)
    {
        ordered_json schema = {{"type", "array"}, {"items", std::move(items)}};
        if (least > 0) schema["minItems"] = static_cast<std::int64_t>(least);
        if (std::isfinite(most)) schema["maxItems"] = static_cast<std::int64_t>(most);
        return schema;
    }

    template <class T>
    ordered_json reference()
    {
        if (!definitions_.contains(Fields<T>::name))
        {
            definitions_[Fields<T>::name] = nullptr; // holds its place
            ordered_json schema = object_schema<T>();
            definitions_[Fields<T>::name] = std::move(schema);
        }
        return {{"$ref", std::string("#/$defs/") + Fields<T>::name}};
    }

    ordered_json field_schema();

    ordered_json definitions_ = ordered_json::object();
};

/// Adds the fields of one type to an object's schema.
template <class T>
class PropertyWriter
{
public:
    PropertyWriter(SchemaWriter& writer, ordered_json& schema) : writer_(writer), schema_(schema) {}

    template <class M>
    void operator()(const char* name, M T::* member, const Rule& rule)
    {
        ordered_json property = writer_.of(static_cast<const M*>(nullptr), rule);
        const std::string unit = *rule.unit ? std::string("[") + rule.unit + "]" : "";
        const std::string words = rule.what + std::string(*rule.what && *rule.unit ? " " : "") + unit;
        if (!words.empty()) property["description"] = words;
        if (!rule.is_required && is_plain(defaults_.*member)) property["default"] = json_of(defaults_.*member);
        if (std::string_view(name) == "needs") property["items"] = {{"enum", feature_words()}};
        schema_["properties"][name] = std::move(property);
        if (rule.is_required) schema_["required"].push_back(name);
    }
    template <class M>
    void flat(M T::*)
    {
        PropertyWriter<M> part(writer_, schema_);
        Fields<M>::visit(part);
    }
    template <class M>
    void choice(M T::*, const Rule& rule)
    {
        add_keys(static_cast<const M*>(nullptr), rule.is_required);
    }
    template <class... Ts>
    void add_keys(const std::variant<Ts...>*, bool is_required)
    {
        using Variant = std::variant<Ts...>;
        std::size_t i = 0;
        ordered_json one_of = ordered_json::array();
        ordered_json any_of = ordered_json::array();
        const auto add = [&](ordered_json property)
        {
            const std::string key(Keys<Variant>::all[i++]);
            schema_["properties"][key] = std::move(property);
            one_of.push_back({{"required", {key}}});
        };
        (add(writer_.of(static_cast<const Ts*>(nullptr), about(""))), ...);
        any_of = one_of;
        if (!is_required) one_of.push_back({{"not", {{"anyOf", std::move(any_of)}}}});
        schema_["oneOf"] = std::move(one_of);
    }
    template <class Variant>
    void add_keys(const std::optional<Variant>*, bool is_required)
    {
        add_keys(static_cast<const Variant*>(nullptr), is_required);
    }

private:
    // Defaults that say something: not those of objects and lists, nor that what may be left out is not there.
    template <class M>
    static bool is_plain(const M& value)
    {
        if constexpr (std::is_same_v<M, float>)
            return std::isfinite(value);
        else
            return std::is_arithmetic_v<M> || std::is_enum_v<M> || std::is_same_v<M, Vec2> || std::is_same_v<M, Rot>;
    }

    SchemaWriter& writer_;
    ordered_json& schema_;
    const T defaults_ = {};
};

template <class T>
ordered_json SchemaWriter::object_schema()
{
    ordered_json schema;
    schema["description"] = Fields<T>::what;
    schema["type"] = "object";
    schema["properties"] = ordered_json::object();
    schema["additionalProperties"] = false;
    PropertyWriter<T> properties(*this, schema);
    Fields<T>::visit(properties);
    return schema;
}

ordered_json SchemaWriter::field_schema()
{
    ordered_json schema = {{"type", "object"}, {"properties", ordered_json::object()}, {"additionalProperties", false}};
    PropertyWriter<SceneFile> properties(*this, schema);
    properties.add_keys(static_cast<const Field*>(nullptr), true);
    return schema;
}

} // namespace

std::string scene_file_schema() { return SchemaWriter().text(); }

} // namespace carom::scene_file
