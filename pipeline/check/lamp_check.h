// Finds lamps and other fixtures that hide the table from a camera above it.
#pragma once

#include <map>
#include <string>
#include <vector>

#include <Imath/ImathBox.h>

#include "pipeline/shot/shot.h"
#include "render/camera/camera_state.h"

namespace carom::pipeline {

/// What hangs above the table of a shot, and how much of the cloth it hides from cameras.
class LampCheck {
  public:
    /// Considers lights with a surface that the camera sees, and objects that are only visible and
    /// do not move. A mesh is read from its file when the first camera above it is checked; one
    /// that cannot be read or that has more than 4 MiB hides nothing, and neither does an object
    /// with holes by its opacity. `shot` must outlive the object.
    explicit LampCheck(const Shot& shot);

    /// Whether the shot has a table and the camera looks down on it: at least 45 degrees below the
    /// horizontal.
    [[nodiscard]] bool is_above_table(const render::CameraState& camera) const;

    /// The share of the cloth in the picture, in (0, 1], that each lamp hides from a camera above
    /// the table, by the lamp's name. Lamps that hide nothing are left out.
    [[nodiscard]] std::map<std::string, double> hidden_shares(const render::CameraState& camera);

  private:
    /// An object in its own axes: its triangles or, without any, its box.
    struct Fixture {
        std::string name;
        Mat44 object_from_world;
        Imath::Box3d box;
        std::vector<Vec3> corners;  // three for each triangle
    };

    void find_fixtures();
    [[nodiscard]] bool is_hidden_by(const Fixture& fixture, const Vec3& camera,
                                    const Vec3& point) const;

    const Shot& shot_;
    bool has_fixtures_ = false;
    std::vector<Fixture> fixtures_;
};

}  // namespace carom::pipeline
