// Poses of a moving body at the times of rays, in lanes. Included as render/lanes/kernels/vectors.h
// is.

/// Numbers of a piece of a list, which may be another one in each lane. They are named by their
/// place in the first piece of the list.
template <class L, class Piece>
struct PieceAt {
    const Piece& first_piece;
    IntOf<L> index;
    bool is_first;  // in all lanes

    /// The piece of one motion that is valid at a time.
    CAROM_KERNEL PieceAt(const List<Piece>& list, ValueOf<L> time)
        : first_piece(list[0]), index(L::all_int(0)), is_first(list.count() == 1) {
        search(L::all_int(list.count() - 1), list.count(), time);
    }
    /// Of motions whose pieces are, in each lane, those from `begin` to before `end`, at most
    /// `most`.
    CAROM_KERNEL PieceAt(const List<Piece>& list, IntOf<L> begin, IntOf<L> end, int most,
                         ValueOf<L> time)
        : first_piece(list[0]), index(begin), is_first(false) {
        search(end - L::all_int(1), most, time);
    }

    template <class Vector>
    [[nodiscard]] CAROM_KERNEL Vec3Of<L> vector(const Vector& of_first) const {
        return {place(of_first.x), place(of_first.y), place(of_first.z)};
    }
    [[nodiscard]] CAROM_KERNEL ValueOf<L> place(const float& of_first) const {
        return is_first ? L::all(of_first) : gathered(&of_first, index);
    }

  private:
    CAROM_KERNEL void search(IntOf<L> last, std::int32_t most, ValueOf<L> time) {
        std::int32_t step = 1;
        while (step < most) {
            step *= 2;
        }
        for (step /= 2; step > 0; step /= 2) {
            const auto other = L::smaller_int(index + L::all_int(step), last);
            const auto begins = gathered(&first_piece.start, other);
            index = L::select_int(L::is_at_most(begins, time), other, index);
        }
    }
    CAROM_KERNEL static ValueOf<L> gathered(const void* of_first, IntOf<L> at) {
        constexpr auto kSize = static_cast<std::int32_t>(sizeof(Piece));
        return L::from_bits(L::from_word(L::gather_bytes(of_first, L::product(at, kSize))));
    }
};

/// Where the body's origin is.
template <class L>
CAROM_KERNEL Vec3Of<L> position_at(const PieceAt<L, PathPiece>& at, ValueOf<L> time) {
    const PathPiece& first = at.first_piece;
    return point_on_path<L>(at.vector(first.c[0]), at.vector(first.c[1]), at.vector(first.c[2]),
                            at.vector(first.c[3]), time - at.place(first.start));
}
template <class L>
CAROM_KERNEL Vec3Of<L> position_at(const MotionPieces& motion, ValueOf<L> time) {
    return position_at<L>(PieceAt<L, PathPiece>(motion.path, time), time);
}

/// `begin`, turned further by twice an angle about an axis.
template <class L>
CAROM_KERNEL RotationOf<L> rotation_after(const RotationOf<L>& begin, const Vec3Of<L>& axis,
                                          ValueOf<L> half_angle) {
    const SinCosOf<L> since = sin_cos_turn<L>(half_angle * L::all(0.5f * kInversePi));
    return RotationOf<L>{since.cosine, axis * since.sine} * begin;
}

/// How the body is turned.
template <class L>
CAROM_KERNEL RotationOf<L> rotation_at(const PieceAt<L, RotationPiece>& at, ValueOf<L> time) {
    const RotationPiece& first = at.first_piece;
    RotationOf<L> begin{at.place(first.world_from_body.r), at.vector(first.world_from_body.v)};
    const auto half_angle = at.place(first.half_angle);
    const auto turns = L::is_less(L::all(0), half_angle);
    if (L::none(turns)) {
        return begin;
    }
    const auto fraction = L::smaller(
        L::larger((time - at.place(first.start)) * at.place(first.inverse_duration), L::all(0)),
        L::all(1));
    const RotationOf<L> all =
        rotation_after<L>(begin, at.vector(first.axis), fraction * half_angle);
    return {L::select(turns, all.real, begin.real), select<L>(turns, all.vector, begin.vector)};
}

template <class L>
CAROM_KERNEL RotationOf<L> rotation_at(const MotionPieces& motion, ValueOf<L> time) {
    return rotation_at<L>(PieceAt<L, RotationPiece>(motion.turns, time), time);
}

template <class L>
CAROM_KERNEL PoseOf<L> pose_at(const MotionPieces& motion, ValueOf<L> time) {
    return {position_at<L>(motion, time), rotation_at<L>(motion, time)};
}

/// The axes of a body that may be at rest, and whose orientation may not matter.
template <class L>
struct BodyOf {
    bool moves, turns;
    PoseOf<L> pose;

    [[nodiscard]] CAROM_KERNEL Vec3Of<L> vector(const Vec3Of<L>& world) const {
        return turns ? pose.rotation.undo(world) : world;
    }
    [[nodiscard]] CAROM_KERNEL Vec3Of<L> point(const Vec3Of<L>& world) const {
        return moves ? vector(world - pose.position) : world;
    }
    [[nodiscard]] CAROM_KERNEL Vec3Of<L> to_world(const Vec3Of<L>& vector) const {
        return turns ? pose.rotation.apply(vector) : vector;
    }
};

/// `motion` without pieces: at rest.
template <class L>
CAROM_KERNEL BodyOf<L> body_at(const MotionPieces& motion, bool is_round, ValueOf<L> time) {
    const auto zero = L::all(0);
    const bool moves = motion.path.exists();
    BodyOf<L> body{
        moves, moves && !is_round, {{zero, zero, zero}, {L::all(1), {zero, zero, zero}}}};
    if (body.moves) {
        body.pose.position = position_at<L>(motion, time);
    }
    if (body.turns) {
        body.pose.rotation = rotation_at<L>(motion, time);
    }
    return body;
}
