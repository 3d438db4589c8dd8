// Finds the bodies that may touch each other during a step.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "sim/scheduler/moving_body.h"
#include "sim/spatial/aabb_tree.h"

namespace carom::sim {

/// Where a body is at an instant of a step, and in which mode it was when the step began.
struct Placement {
    MotionState state;
    Mode mode = Mode::gone;

    [[nodiscard]] bool is_in_solver() const { return mode == Mode::solver; }
};

/// The pairs of bodies near each other, with a margin for their motion, so that they hold for
/// several steps (the list of Verlet, Computer "experiments" on classical fluids I, Phys. Rev. 159,
/// 1967). A new list costs n log n for n bodies in the solver; a sleeping body only costs the look
/// whether it has stayed where it was.
class NearPairs {
  public:
    using Pair = std::pair<std::uint32_t, std::uint32_t>;

    /// `gap`: of the bounding spheres of two near bodies, m.
    explicit NearPairs(double gap) : gap_(gap) {}

    /// Pairs (i, k), i < k, in ascending order, of two bodies in the solver, or of one and a
    /// sleeping one: all whose bounding spheres are less than the gap apart, and others.
    /// `placed`: the placements of `bodies`, in the same order. The result is valid until the next
    /// call, which has to be for the same bodies.
    [[nodiscard]] const std::vector<Pair>& find(std::span<const MovingBody> bodies,
                                                std::span<const Placement> placed);

    /// The bodies in the solver, ascending; as valid as the pairs.
    [[nodiscard]] const std::vector<std::uint32_t>& in_solver() const { return in_solver_; }

  private:
    struct Member {
        std::uint32_t number = 0;  // of a body
        Vec3 centre{0, 0, 0};
        // The list holds while the body is this near to `centre`, m. 0: it sleeps; -1: it is in no
        // group.
        double slack = -1;

        [[nodiscard]] bool contains(const Vec3& place) const;
    };
    class Group {
      public:
        void update(std::vector<Member> members, std::span<const MovingBody> bodies);
        [[nodiscard]] const std::vector<Member>& members() const { return members_; }
        [[nodiscard]] const AabbTree& tree() const { return tree_; }

      private:
        std::vector<Member> members_;
        AabbTree tree_;  // of boxes that contain them while the list holds
    };
    [[nodiscard]] bool holds(std::span<const Placement> placed) const;
    void add_pairs(const Member& member, const Aabb& box);

    double gap_;
    std::array<Group, 3> groups_;  // those that sleep, are slow, are fast
    std::vector<Member> known_;    // of all bodies
    std::vector<std::uint32_t> in_solver_;
    std::vector<std::uint32_t> found_;
    std::vector<Pair> pairs_;
};

}  // namespace carom::sim
