// Changes the parts of a described value one after another, by the lists of its fields.
#pragma once

#include <array>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include <gtest/gtest.h>

#include "core/fields.h"
#include "core/hash.h"
#include "core/vectors.h"

namespace carom::test {

/// Changes every field of every struct in a value, the first element of every vector, every
/// alternative of a variant, and every optional with and without a value.
class FieldChanges {
  public:
    /// Called while one part is changed. `counts`: true if the lists say that the part is hashed.
    using Report = std::function<void(const std::string& place, bool counts)>;

    /// `file`: an existing file, used as value of fields that name a file.
    explicit FieldChanges(Report report, std::string file = {})
        : report_(std::move(report)), file_(std::move(file)) {}

    /// Changes the parts of `value`; each change is undone before the next one. A type without an
    /// overload here needs a function change_value(T&).
    template <class T>
    void of(T& value, const std::string& place = "", bool counts = true) {
        if constexpr (Described<T>) {
            for_each_field(value, [&](const auto& field, auto& member) {
                this->of_field(field, member, place + "." + std::string(field.name), counts);
            });
        } else {
            const T before = value;
            change(value, place, counts);
            value = before;
        }
    }

  private:
    template <class Field, class T>
    void of_field(const Field& /*field*/, T& value, const std::string& place, bool counts) {
        if constexpr (Field::kRole == FieldRole::file) {
            const T before = std::exchange(value, file_);
            report_(place, counts);
            value = before;
        } else if constexpr (Field::kRole == FieldRole::unhashed) {
            of(value, place, false);
        } else if constexpr (Field::kRole != FieldRole::hashed_elsewhere) {
            of(value, place, counts);
        }
    }

    template <class T>
    void change(T& value, const std::string& place, bool counts) {
        if constexpr (std::is_same_v<T, bool>) {
            value = !value;
        } else if constexpr (std::is_enum_v<T>) {
            value = static_cast<T>(static_cast<std::underlying_type_t<T>>(value) + 1);
        } else if constexpr (std::is_arithmetic_v<T>) {
            value += 1;
        } else {
            change_value(value);
        }
        report_(place, counts);
    }

    void change(std::monostate& /*nothing*/, const std::string& /*place*/, bool /*counts*/) {}

    void change(std::string& text, const std::string& place, bool counts) {
        text += "x";
        report_(place, counts);
    }

    void change(Vec2& v, const std::string& place, bool counts) {
        of(v.x, place + ".x", counts);
        of(v.y, place + ".y", counts);
    }

    void change(Vec3& v, const std::string& place, bool counts) {
        of(v.x, place + ".x", counts);
        of(v.y, place + ".y", counts);
        of(v.z, place + ".z", counts);
    }

    void change(Quat& q, const std::string& place, bool counts) {
        of(q.r, place + ".w", counts);
        of(q.v, place, counts);
    }

    void change(Mat44& map, const std::string& place, bool counts) {
        for (double* entry = map.getValue(); entry != map.getValue() + 16; ++entry) {
            of(*entry, place + "[" + std::to_string(entry - map.getValue()) + "]", counts);
        }
    }

    template <class T, std::size_t kSize>
    void change(std::array<T, kSize>& values, const std::string& place, bool counts) {
        for (std::size_t i = 0; i < kSize; ++i) {
            of(values[i], place + "[" + std::to_string(i) + "]", counts);
        }
    }

    template <class T>
    void change(std::vector<T>& values, const std::string& place, bool counts) {
        values.push_back(make<T>());
        report_(place + " and another", counts);
        of(values.front(), place + "[0]", counts);
    }

    template <class T>
    void change(std::map<std::pair<std::string, std::string>, T>& values, const std::string& place,
                bool counts) {
        using Key = std::pair<std::string, std::string>;
        for (const Key& key : {Key("x", "x"), Key("x", "y"), Key("y", "x")}) {
            values.clear();
            of_new(values[key], place + "[" + key.first + key.second + "]", counts);
        }
    }

    template <class T>
    void change(std::optional<T>& value, const std::string& place, bool counts) {
        if (value) {
            of(*value, place, counts);
            value.reset();
            report_(place + " removed", counts);
        } else {
            of_new(value.emplace(make<T>()), place, counts);
        }
    }

    template <class... T>
    void change(std::variant<T...>& value, const std::string& place, bool counts) {
        std::visit([&](auto& alternative) { of(alternative, place, counts); }, value);
        const std::size_t before = value.index();
        [&]<std::size_t... kIndex>(std::index_sequence<kIndex...>) {
            ((kIndex == before
                  ? void()
                  : of_new(value.template emplace<kIndex>(
                               make<std::variant_alternative_t<kIndex, std::variant<T...>>>()),
                           place + "<" + std::to_string(kIndex) + ">", counts)),
             ...);
        }
        (std::index_sequence_for<T...>{});
    }

    /// A part that is shared and constant, so that each change replaces it. Parts may contain parts
    /// of their own kind.
    template <Described T>
    void change(std::shared_ptr<const T>& value, const std::string& place, bool counts) {
        T part = value ? *value : make<T>();
        const auto put = [&] { value = std::make_shared<const T>(part); };
        if (!value) {
            put();
            report_(place + " given", counts);
        }
        if (shared_parts_ == kMostSharedParts) {
            return;
        }
        FieldChanges changes(
            [&](const std::string& changed, bool does_count) {
                put();
                report_(changed, does_count);
            },
            file_);
        changes.shared_parts_ = shared_parts_ + 1;
        changes.of(part, place, counts);
        put();
    }

    /// A new value. Imath's vectors leave their numbers undefined unless they are given.
    template <class T>
    static T make() {
        if constexpr (std::is_same_v<T, Vec2> || std::is_same_v<T, Vec3>) {
            return T(0);
        } else {
            T value = T();
            define(value);
            return value;
        }
    }

    /// Gives a number to vectors that are the first alternative of a variant.
    template <class T>
    static void define(T& value) {
        if constexpr (Described<T>) {
            for_each_field(value, [](const auto& /*field*/, auto& member) { define(member); });
        }
    }
    template <class... T>
    static void define(std::variant<Vec3, T...>& value) {
        if (value.index() == 0) {
            value = Vec3(0);
        }
    }

    /// Reports a new part and then changes it.
    template <class T>
    void of_new(T& value, const std::string& place, bool counts) {
        report_(place, counts);
        of(value, place, counts);
    }

    static constexpr int kMostSharedParts = 2;

    Report report_;
    std::string file_;
    int shared_parts_ = 0;  // around the one that is being changed
};

/// Expects that every change of `value` that counts gives a new `hash` and that all others leave it
/// unchanged. Returns the number of different hashes.
template <class T>
std::size_t expect_changes_count(T& value, const std::function<Hash128()>& hash,
                                 const std::string& file = {}) {
    std::set<Hash128> hashes{hash()};
    FieldChanges([&](const std::string& place,
                     bool counts) { EXPECT_EQ(hashes.insert(hash()).second, counts) << place; },
                 file)
        .of(value);
    return hashes.size();
}

}  // namespace carom::test
