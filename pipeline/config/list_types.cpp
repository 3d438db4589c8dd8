#include "pipeline/config/list_types.h"

#include "pipeline/config/combined_types.h"
#include "pipeline/config/number_types.h"

namespace carom::pipeline::config {

namespace {

template <class V, int kCount>
ValueType<V> vector_type(Dimension dimension, const Range& range) {
    const ValueType<std::vector<double>> list = list_of(quantity(dimension, range), kCount, kCount);
    ValueType<V> result = convert<V>(list, [](const std::vector<double>& values) {
        V vector;
        for (int i = 0; i < kCount; ++i) {
            vector[i] = values[i];
        }
        return vector;
    });
    result.show = [list](const V& vector) {
        std::vector<double> values;
        values.reserve(kCount);
        for (int i = 0; i < kCount; ++i) {
            values.push_back(vector[i]);
        }
        return list.show(values);
    };
    return result;
}

}  // namespace

bool check_list(Reader& reader, const Node& node, const TypeInfo& type) {
    if (!node.is_sequence()) {
        reader.wrong_type(node, describe(type));
        return false;
    }
    const int count = static_cast<int>(node.items.size());
    if (count < type.fewest || (type.most >= 0 && count > type.most)) {
        const std::string allowed =
            type.most < 0 && type.fewest == 1 ? describe(type) + " (at least one)" : describe(type);
        reader.error(node.place, reader.value_name() + " must be " + allowed + ", not of " +
                                     std::to_string(count));
        return false;
    }
    return true;
}

ValueType<Vec3> vector3(Dimension dimension, Range range) {
    return vector_type<Vec3, 3>(dimension, range);
}

ValueType<Vec2> vector2(Dimension dimension, Range range) {
    return vector_type<Vec2, 2>(dimension, range);
}

ValueType<Coordinates> coordinates(Dimension dimension) {
    return convert<Coordinates>(list_of(quantity(dimension), 2, 3),
                                [](const std::vector<double>& values) {
                                    const bool has_z = values.size() == 3;
                                    const double z = has_z ? values[2] : 0.0;
                                    return Coordinates{Vec3(values[0], values[1], z), has_z};
                                });
}

}  // namespace carom::pipeline::config
