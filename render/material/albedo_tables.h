// The albedo tables of a scene, each of which is computed once.
#pragma once

#include <tuple>

#include "core/memo_table.h"
#include "render/material/albedo_table.h"

namespace carom::render {

/// The functions of AlbedoTable of the same names, for any number of threads. The balls of a set
/// have the same finish, and so the same tables.
class AlbedoTables {
  public:
    [[nodiscard]] const AlbedoTable& of_dielectric(float alpha, float ior) {
        return get(Lobe::dielectric, alpha, ior,
                   [&] { return AlbedoTable::of_dielectric(alpha, ior); });
    }
    [[nodiscard]] const AlbedoTable& of_mirrors(float alpha) {
        return get(Lobe::mirrors, alpha, 0, [&] { return AlbedoTable::of_mirrors(alpha); });
    }
    [[nodiscard]] const AlbedoTable& of_glass(float alpha, float index) {
        return get(Lobe::glass, alpha, index, [&] { return AlbedoTable::of_glass(alpha, index); });
    }
    [[nodiscard]] const AlbedoTable& of_sheen() {
        return get(Lobe::sheen, 0, 0, [] { return AlbedoTable::of_sheen(); });
    }

  private:
    enum class Lobe { dielectric, mirrors, glass, sheen };

    template <class Make>
    const AlbedoTable& get(Lobe lobe, float alpha, float index, const Make& make) {
        return tables_.get({lobe, alpha, index}, make);
    }

    MemoTable<std::tuple<Lobe, float, float>, AlbedoTable> tables_;
};

}  // namespace carom::render
