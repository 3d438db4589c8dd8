// Rays of a thin-lens camera in lanes. Included as render/lanes/kernels/vectors.h is.

/// The parameters of a camera at one time. See CameraAtTime.
template <class L>
struct CameraFrameOf {
    Vec3Of<L> position, forward, right, up;
    ValueOf<L> pixel_size, focus_distance, lens_radius, blade_turns;
};

/// The numbers of a camera sample (sampler.h).
template <class L>
struct CameraNumbersOf {
    Vec2Of<L> pixel, lens;
    ValueOf<L> time;
};

template <class L>
struct CameraRayOf {
    Vec3Of<L> origin, direction;
    ValueOf<L> time;
    ValueOf<L> weight;  // of its light
};

/// A point of the pupil in radii of the lens, before it is squeezed.
template <class L>
struct PupilPointOf {
    Vec2Of<L> place;
    ValueOf<L> weight;
};

template <class L>
CAROM_KERNEL ValueOf<L> mixed(float from, float to, ValueOf<L> weight) {
    return L::all(from) + weight * (L::all(to) - L::all(from));
}
template <class L, class Vector>
CAROM_KERNEL Vec3Of<L> mixed_vector(const Vector& from, const Vector& to, ValueOf<L> weight) {
    return {mixed<L>(from.x, to.x, weight), mixed<L>(from.y, to.y, weight),
            mixed<L>(from.z, to.z, weight)};
}

template <class L>
CAROM_KERNEL CameraFrameOf<L> frame_at_rest(const CameraAtTime& frame) {
    return {all_of<L>(frame.position), all_of<L>(frame.forward), all_of<L>(frame.right),
            all_of<L>(frame.up),       L::all(frame.pixel_size), L::all(frame.focus_distance),
            L::all(frame.lens_radius), L::all(frame.blade_turns)};
}

template <class L>
CAROM_KERNEL CameraFrameOf<L> moving_frame(const CameraAtTime& a, const CameraAtTime& b,
                                           ValueOf<L> time) {
    CameraFrameOf<L> frame;
    frame.position = mixed_vector<L>(a.position, b.position, time);
    frame.forward = unit<L>(mixed_vector<L>(a.axis, b.axis, time));
    frame.right = unit<L>(cross(frame.forward, mixed_vector<L>(a.upright, b.upright, time)));
    frame.up = cross(frame.right, frame.forward);
    if (a.roll != 0 || b.roll != 0) {
        const SinCosOf<L> turn =
            sin_cos_turn<L>(mixed<L>(a.roll, b.roll, time) * L::all(0.5f * kInversePi));
        const Vec3Of<L> level = frame.right;
        frame.right = level * turn.cosine + frame.up * turn.sine;
        frame.up = frame.up * turn.cosine - level * turn.sine;
    }
    frame.pixel_size = mixed<L>(a.pixel_size, b.pixel_size, time);
    frame.focus_distance = mixed<L>(a.focus_distance, b.focus_distance, time);
    frame.lens_radius = mixed<L>(a.lens_radius, b.lens_radius, time);
    frame.blade_turns = mixed<L>(a.blade_rotation, b.blade_rotation, time) / L::all(2 * kPi);
    return frame;
}

/// `time` within the shutter, [0, 1].
template <class L>
CAROM_KERNEL CameraFrameOf<L> frame_at(const CameraConstants& camera, ValueOf<L> time) {
    return camera.moves ? moving_frame<L>(camera.open, camera.close, time)
                        : frame_at_rest<L>(camera.open);
}

/// A point of the open pupil, uniformly distributed.
template <class L>
CAROM_KERNEL Vec2Of<L> sample_pupil(const CameraFrameOf<L>& frame, int blades, const Vec2Of<L>& u) {
    return blades == 0 ? sample_disk<L>(u) : sample_polygon<L>(u, blades, frame.blade_turns);
}

/// From the centre of the lens to a point of the pupil.
template <class L>
CAROM_KERNEL Vec3Of<L> point_on_lens(const CameraFrameOf<L>& frame, const LensShapeConstants& shape,
                                     const Vec2Of<L>& pupil) {
    return frame.right * (frame.lens_radius * (L::all(shape.squeeze) * pupil.x)) +
           frame.up * (frame.lens_radius * pupil.y);
}

/// Where the picture has without distortion what it has at `place` (pixels from its centre). See
/// lens_distortion.h.
template <class L>
CAROM_KERNEL Vec2Of<L> undistorted(const LensShapeConstants& shape, const Vec2Of<L>& place) {
    const auto scale = L::all(1) / (L::all(1) + L::all(shape.distortion) *
                                                    (place.x * place.x + place.y * place.y));
    return {place.x * scale, place.y * scale};
}

/// A point on the edge of the open pupil. Between two of them the pupil has an area in proportion
/// to the difference of their turns, [0, 1].
template <class L>
CAROM_KERNEL Vec2Of<L> pupil_edge(const CameraFrameOf<L>& frame, int blades, ValueOf<L> turn) {
    if (blades == 0) {
        const SinCosOf<L> angle = sin_cos_turn<L>(turn);
        return {angle.cosine, angle.sine};
    }
    const auto count = static_cast<float>(blades);
    const auto scaled = turn * L::all(count);
    const auto blade = L::rounded_down(scaled);
    const auto second = scaled - blade;
    const auto first = L::all(1) - second;
    const SinCosOf<L> a = sin_cos_turn<L>(blade / L::all(count) + frame.blade_turns);
    const SinCosOf<L> b = sin_cos_turn<L>((blade + L::all(1)) / L::all(count) + frame.blade_turns);
    return {first * a.cosine + second * b.cosine, first * a.sine + second * b.sine};
}

/// Which part of the way from the centre of the pupil to `edge` is inside of the second opening,
/// whose centre is there.
template <class L>
CAROM_KERNEL ValueOf<L> open_part(const LensShapeConstants& shape, const Vec2Of<L>& centre,
                                  const Vec2Of<L>& edge) {
    const auto along = edge.x * centre.x + edge.y * centre.y;
    const auto edge2 = edge.x * edge.x + edge.y * edge.y;
    const auto inside2 = L::all(shape.cat_eye_ratio * shape.cat_eye_ratio) -
                         (centre.x * centre.x + centre.y * centre.y);
    const auto part =
        (along + L::root(L::larger(L::all(0), along * along + edge2 * inside2))) / edge2;
    return L::larger(L::all(0), L::smaller(L::all(1), part));
}

/// A point of the part of the pupil that the second opening leaves for `place` (pixels from the
/// picture's centre), nearly uniform. Weighted light has the mean over the open pupil of light that
/// is 0 outside of that part. No sample is lost, and the weights of a place are nearly equal, so
/// that what is in focus is as free of noise as without it.
///
/// In each direction the share f of the radius is open, so the open area is distributed over the
/// turns as f^2. A turn is drawn from a density that is linear between values of f^2 at kNodes
/// turns; the weight is f^2 over it.
template <class L>
CAROM_KERNEL PupilPointOf<L> sample_behind_second_opening(const CameraFrameOf<L>& frame,
                                                          const LensShapeConstants& shape,
                                                          int blades, const Vec2Of<L>& u,
                                                          const Vec2Of<L>& place) {
    using V = ValueOf<L>;
    constexpr int kNodes = 16;
    constexpr float kLeast = 1e-3f;  // of the density, so that no direction is left out
    const Vec2Of<L> centre{place.x * L::all(-shape.cat_eye_shift),
                           place.y * L::all(-shape.cat_eye_shift)};
    V values[kNodes + 1];
    V total = L::all(0);
    for (int node = 0; node <= kNodes; ++node) {
        const V turn = L::all(static_cast<float>(node) / kNodes);
        const V part = open_part<L>(shape, centre, pupil_edge<L>(frame, blades, turn));
        values[node] = L::larger(L::all(kLeast), part * part);
        if (node > 0) {
            total = total + L::all(0.5f) * (values[node - 1] + values[node]);
        }
    }
    const V wanted = u.x * total;
    V sum = L::all(0);
    V from = values[0];
    V to = values[1];
    V before = L::all(0);  // the sum where the chosen interval begins
    V interval = L::all(0);
    for (int node = 0; node < kNodes; ++node) {
        const auto is_beyond = L::is_at_most(sum, wanted);
        from = L::select(is_beyond, values[node], from);
        to = L::select(is_beyond, values[node + 1], to);
        before = L::select(is_beyond, sum, before);
        interval = L::select(is_beyond, L::all(static_cast<float>(node)), interval);
        sum = sum + L::all(0.5f) * (values[node] + values[node + 1]);
    }
    const V t = L::smaller(L::all(1), L::all(2) * (wanted - before) / (from + to));
    const V inside = t * (from + to) / (from + L::root(from * from + t * (to * to - from * from)));
    const V density = (from + inside * (to - from)) * L::all(kNodes) / total;
    const V turn = L::smaller((interval + inside) / L::all(kNodes), L::all(kOneMinusEpsilon));
    const Vec2Of<L> edge = pupil_edge<L>(frame, blades, turn);
    const V part = open_part<L>(shape, centre, edge);
    const V radius = part * L::root(u.y);
    return {{edge.x * radius, edge.y * radius}, part * part / density};
}

/// See ThinLensCamera::ray.
template <class L>
CAROM_KERNEL CameraRayOf<L> camera_ray(const CameraConstants& camera, const Vec2Of<L>& pixel,
                                       const CameraNumbersOf<L>& u) {
    using V = ValueOf<L>;
    const V time = sample_trapezoid<L>(u.time, camera.switch_ratio);
    const CameraFrameOf<L> frame = frame_at<L>(camera, time);
    const PixelFilterTables& filter = camera.filter;
    const V x =
        pixel.x + L::all(0.5f) - L::all(camera.centre.x) + filter_offset<L>(filter, u.pixel.x);
    const V y = L::all(camera.centre.y - 0.5f) - pixel.y - filter_offset<L>(filter, u.pixel.y);
    const LensShapeConstants& shape = camera.shape;
    const Vec2Of<L> place{x, y};
    Vec2Of<L> seen = place;
    if (shape.distortion != 0) {
        seen = undistorted<L>(shape, place);
    }
    const Vec3<V> picture = frame.forward + frame.right * (seen.x * frame.pixel_size) +
                            frame.up * (seen.y * frame.pixel_size);
    if (!camera.has_lens) {
        return {frame.position, unit<L>(picture), time, L::all(1)};
    }
    PupilPointOf<L> pupil;
    if (shape.cat_eye_shift > 0) {
        pupil = sample_behind_second_opening<L>(frame, shape, camera.blades, u.lens, place);
    } else {
        pupil = {sample_pupil<L>(frame, camera.blades, u.lens), L::all(1)};
    }
    const Vec3<V> arm = point_on_lens<L>(frame, shape, pupil.place);
    return {frame.position + arm, unit<L>(picture * frame.focus_distance - arm), time,
            pupil.weight};
}
