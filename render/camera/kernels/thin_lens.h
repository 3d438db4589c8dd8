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

/// A point on the lens, from its centre.
template <class L>
CAROM_KERNEL Vec3Of<L> point_on_lens(const CameraFrameOf<L>& frame, int blades,
                                     const Vec2Of<L>& u) {
    const Vec2Of<L> p =
        blades == 0 ? sample_disk<L>(u) : sample_polygon<L>(u, blades, frame.blade_turns);
    return frame.right * (frame.lens_radius * p.x) + frame.up * (frame.lens_radius * p.y);
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
    const Vec3<V> picture =
        frame.forward + frame.right * (x * frame.pixel_size) + frame.up * (y * frame.pixel_size);
    if (!camera.has_lens) {
        return {frame.position, unit<L>(picture), time};
    }
    const Vec3<V> arm = point_on_lens<L>(frame, camera.blades, u.lens);
    return {frame.position + arm, unit<L>(picture * frame.focus_distance - arm), time};
}
