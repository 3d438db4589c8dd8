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
    ValueOf<L> weight;  // of its light, [0, 1]
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

/// Moves a point of the open pupil along its radius, so that the whole pupil is mapped to the part
/// that the second opening leaves for `place` (pixels from the picture's centre). A radius that
/// becomes shorter by the factor f covers f^2 of the area, which is the weight: a mean over the
/// open pupil of weighted light is that of light over the open pupil that is 0 outside the part. No
/// sample is lost, and well-distributed samples stay so.
template <class L>
CAROM_KERNEL PupilPointOf<L> behind_second_opening(const LensShapeConstants& shape, int blades,
                                                   ValueOf<L> u, const Vec2Of<L>& pupil,
                                                   const Vec2Of<L>& place) {
    const auto size = L::root(pupil.x * pupil.x + pupil.y * pupil.y);
    const auto is_centre = L::is_equal(size, L::all(0));
    const auto inverse = L::all(1) / L::select(is_centre, L::all(1), size);
    const auto centre_x = place.x * L::all(-shape.cat_eye_shift);
    const auto centre_y = place.y * L::all(-shape.cat_eye_shift);
    const auto along = (pupil.x * centre_x + pupil.y * centre_y) * inverse;
    const auto beside2 = centre_x * centre_x + centre_y * centre_y - along * along;
    const float radius2 = shape.cat_eye_ratio * shape.cat_eye_ratio;
    const auto second = along + L::root(L::larger(L::all(0), L::all(radius2) - beside2));
    // `size` is this part of the pupil's own radius in the same direction.
    const auto part = blades == 0 ? size : place_in_polygon<L>(u, blades).part;
    const auto factor = L::select(
        is_centre, L::all(1), L::larger(L::all(0), L::smaller(L::all(1), second * part * inverse)));
    return {{pupil.x * factor, pupil.y * factor}, factor * factor};
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
    PupilPointOf<L> pupil{sample_pupil<L>(frame, camera.blades, u.lens), L::all(1)};
    if (shape.cat_eye_shift > 0) {
        pupil = behind_second_opening<L>(shape, camera.blades, u.lens.x, pupil.place, place);
    }
    const Vec3<V> arm = point_on_lens<L>(frame, shape, pupil.place);
    return {frame.position + arm, unit<L>(picture * frame.focus_distance - arm), time,
            pupil.weight};
}
