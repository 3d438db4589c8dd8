// The points that rays hit, and the surfaces that materials give there, in lanes. Included as
// render/lanes/kernels/vectors.h is.

/// Lanes beyond the last hit repeat it.
template <class L>
struct WaveHitOf {
    IntOf<L> vertex, path, object;
    RayOf<L> ray;
    ValueOf<L> distance;
};

template <class L>
CAROM_KERNEL WaveHitOf<L> hit_at(const SurfaceTask& task, int first) {
    WaveHitOf<L> hit;
    hit.vertex = L::smaller_int(L::from(first), L::all_int(task.last - 1));
    hit.path = gather<L>(task.vertices.path, hit.vertex);
    hit.object = gather<L>(task.vertices.object, hit.vertex);
    hit.ray = {gather<L>(task.paths.origin, hit.path), gather<L>(task.paths.direction, hit.path)};
    hit.distance = gather<L>(task.vertices.distance, hit.vertex);
    return hit;
}

template <class L>
CAROM_KERNEL Vec3Of<L> gather_vector(const WaveHitOf<L>& hit, const SurfaceTask& task,
                                     ShapeRow row) {
    return gather_vector<L>(task.scene.shapes, row, hit.object);
}
template <class L>
CAROM_KERNEL AffineOf<L> gather_map(const WaveHitOf<L>& hit, const SurfaceTask& task,
                                    ShapeRow row) {
    const NumberRows& shapes = task.scene.shapes;
    return {
        {gather_vector<L>(shapes, row, hit.object), gather_vector<L>(shapes, row + 3, hit.object),
         gather_vector<L>(shapes, row + 6, hit.object)},
        gather_vector<L>(shapes, row + 9, hit.object)};
}

/// The pieces of objects' motions at a time.
template <class L, class Piece>
CAROM_KERNEL PieceAt<L, Piece> piece_at(const PiecesOfObjects<Piece>& motions, IntOf<L> object,
                                        ValueOf<L> time) {
    return PieceAt<L, Piece>(motions.pieces, gather<L>(motions.begin, object),
                             gather<L>(motions.begin, object + L::all_int(1)), motions.most, time);
}

/// Where a moving object is at the path's time, and how it is turned.
template <class L>
CAROM_KERNEL Vec3Of<L> position_of(const SurfaceTask& task, const WaveHitOf<L>& hit) {
    const auto time = gather<L>(task.paths.time, hit.path);
    return position_at<L>(piece_at<L>(task.scene.motions.path, hit.object, time), time);
}
template <class L>
CAROM_KERNEL RotationOf<L> turn_of(const SurfaceTask& task, const WaveHitOf<L>& hit) {
    const auto time = gather<L>(task.paths.time, hit.path);
    return rotation_at<L>(piece_at<L>(task.scene.motions.turns, hit.object, time), time);
}

template <class L>
CAROM_KERNEL SurfacePointOf<L> point_on_sphere(const SurfaceTask& task, const WaveHitOf<L>& hit) {
    const Vec3Of<L> centre = task.group.moves
                                 ? position_of<L>(task, hit)
                                 : gather_vector<L>(hit, task, kWorldFromUnitTranslation);
    const auto radius = gather<L>(task.scene.shapes, kHalfSize, hit.object);
    SurfacePointOf<L> point = point_on_sphere<L>(hit.ray, hit.distance, centre, radius);
    if (task.group.needs.position) {
        const AffineOf<L> metres_from_body = gather_map<L>(hit, task, kMetresFromWorld);
        const Vec3Of<L> arm = point.geometric_normal * radius;
        if (task.group.moves) {
            const RotationOf<L> turn = turn_of<L>(task, hit);
            set_place_on_sphere<L>(metres_from_body, turn.undo(arm), radius, task.group.needs,
                                   point);
            turn_gradients<L>(turn, task.group.needs, point);
        } else {
            set_place_on_sphere<L>(metres_from_body, arm, radius, task.group.needs, point);
        }
    }
    return point;
}

/// Ray and point are in the axes of the body; for objects without a track, in the world's. Not
/// inlined: each shape's code is long.
template <class L>
CAROM_KERNEL_OUTLINED SurfacePointOf<L> point_on_shape(const SurfaceTask& task,
                                                       const WaveHitOf<L>& hit,
                                                       const RayOf<L>& ray) {
    const auto zero = L::all(0);
    MappedShapeOf<L> shape;
    shape.unit_from_body = gather_map<L>(hit, task, kUnitFromWorld);
    shape.body_from_unit = gather_map<L>(hit, task, kWorldFromUnit);
    shape.metres_from_body = affine_of<L>(Affine());
    shape.half_size = {zero, zero, zero};
    if (task.group.needs.position) {
        shape.metres_from_body = gather_map<L>(hit, task, kMetresFromWorld);
    }
    if (task.group.needs.uv) {
        shape.half_size = gather_vector<L>(hit, task, kHalfSize);
    }
    shape.parameters = gather_vector<L>(hit, task, kParameters);
    return point_on_shape<L>(task.group.shape, shape, ray, hit.distance, task.group.needs);
}

template <class L>
CAROM_KERNEL SurfacePointOf<L> point_on_mesh(const SurfaceTask& task, const WaveHitOf<L>& hit) {
    const auto byte = L::product(hit.path, static_cast<std::int32_t>(sizeof(Hit)));
    const auto field = [&](std::size_t offset) CAROM_KERNEL_ATTRIBUTE {
        return L::from_word(
            L::gather_bytes(task.hits, byte + L::all_int(static_cast<std::int32_t>(offset))));
    };
    const auto u = L::from_bits(field(offsetof(Hit, u)));
    const auto v = L::from_bits(field(offsetof(Hit, v)));
    const MeshHitOf<L> on_mesh{field(offsetof(Hit, primitive)), u, v};
    const WaveGroup& group = task.group;
    SurfacePointOf<L> point;
    if (group.mesh_is_mapped) {
        const MeshPlaceOf<L> place{gather_map<L>(hit, task, kWorldFromUnit),
                                   gather_map<L>(hit, task, kUnitFromWorld)};
        point = point_on_mesh<L>(group.mesh, on_mesh, &place, group.needs.uv);
    } else {
        point = point_on_mesh<L>(group.mesh, on_mesh, nullptr, group.needs.uv);
    }
    if (group.needs.position) {
        const AffineOf<L> metres_from_body = gather_map<L>(hit, task, kMetresFromWorld);
        point.object_position = metres_from_body.point(point.position);
        if (group.needs.axes) {
            set_axes<L>(metres_from_body, point);
        }
    }
    return point;
}

template <class L>
CAROM_KERNEL SurfacePointOf<L> point_in_body(const SurfaceTask& task, const WaveHitOf<L>& hit,
                                             const RayOf<L>& ray) {
    return task.group.kind == WaveGroup::Kind::mesh ? point_on_mesh<L>(task, hit)
                                                    : point_on_shape<L>(task, hit, ray);
}

template <class L>
CAROM_KERNEL SurfacePointOf<L> point_at(const SurfaceTask& task, const WaveHitOf<L>& hit) {
    if (task.group.kind == WaveGroup::Kind::sphere) {
        return point_on_sphere<L>(task, hit);
    }
    if (task.group.kind == WaveGroup::Kind::box) {
        return point_on_upright_box<L>(hit.ray, hit.distance,
                                       gather_vector<L>(hit, task, kWorldFromUnitTranslation),
                                       gather_vector<L>(hit, task, kHalfSize), task.group.needs);
    }
    if (!task.group.moves) {
        return point_in_body<L>(task, hit, hit.ray);
    }
    const PoseOf<L> body{position_of<L>(task, hit), turn_of<L>(task, hit)};
    return moved<L>(body, task.group.needs, point_in_body<L>(task, hit, body.in_body(hit.ray)));
}

/// Within glass paths lose light (Beer and Lambert).
template <class L>
CAROM_KERNEL void absorb(const SurfaceTask& task, const WaveHitOf<L>& hit, MaskOf<L> from_behind) {
    const auto remains = [&](float rate) CAROM_KERNEL_ATTRIBUTE {
        return exponential_of<L>(L::all(-rate) * hit.distance);
    };
    const V3f& rate = task.group.absorption;
    const Vec3Of<L> throughput = gather<L>(task.paths.throughput, hit.path);
    const Vec3Of<L> reduced =
        throughput * Vec3Of<L>{remains(rate.x), remains(rate.y), remains(rate.z)};
    scatter<L>(select<L>(from_behind, reduced, throughput), task.paths.throughput, hit.path);
}

/// Where rays start: a place, and how far from it along the normal on whose side they stay.
template <class L>
struct StartOf {
    Vec3Of<L> position, normal;
    ValueOf<L> offset;
};

/// The start of rays on the curved surface that a mesh's normals describe, in the lanes in which
/// it faces the viewer. `flat`: on the triangle.
template <class L>
CAROM_KERNEL StartOf<L> start_on_curve(const SurfacePointOf<L>& point, MaskOf<L> from_behind,
                                       const Vec3Of<L>& wo, const StartOf<L>& flat) {
    constexpr float kLeastSlope = 0.25f;
    const Vec3Of<L> normal = flipped<L>(from_behind, point.shading_normal);
    const auto faces = L::is_less(L::all(0), dot(normal, wo));
    const auto slope = L::larger(dot(normal, flat.normal), L::all(kLeastSlope));
    const auto height = L::select(from_behind, point.fall, point.rise);
    return {select<L>(faces, flat.position + normal * (height / slope), flat.position),
            select<L>(faces, normal, flat.normal),
            L::select(faces, flat.offset / slope, flat.offset)};
}

/// Writes the numbers of surfaces that some material's textures give.
template <class L>
CAROM_KERNEL void store_numbers(const SurfaceTask& task, const ResolvedOf<L>& surface, int first) {
    const MaterialTextures& textures = task.scene.textures_of[task.group.material];
    for (int k = 0; k < kTexturedNumbers; ++k) {
        const auto number = textures.varies ? surface.numbers[k] : constant_number<L>(textures, k);
        store<L>(number, task.vertices.numbers[k], first);
    }
}

/// Completes the vertices from `first` on.
template <class L>
CAROM_KERNEL void resolve_surfaces(const SurfaceTask& task, int first) {
    const WaveGroup& group = task.group;
    const SurfaceQueue& vertices = task.vertices;
    const WaveHitOf<L> hit = hit_at<L>(task, first);
    const SurfacePointOf<L> point = point_at<L>(task, hit);
    const Vec3Of<L> wo = opposite<L>(hit.ray.direction);
    const auto width = gather<L>(task.paths.cone_width, hit.path) +
                       gather<L>(task.paths.cone_spread, hit.path) * hit.distance;
    const TexturePointOf<L> textured =
        texture_point<L>(point, group.needs, wo, width, L::all(kLeastConeCosine));
    const ResolvedOf<L> surface =
        resolve_surface<L>(task.scene.textures, task.scene.textures_of[group.material], textured,
                           point.geometric_normal, point.shading_normal, wo);
    const auto radius = gather<L>(task.scene.shapes, kBoundingRadius, hit.object);
    StartOf<L> start{point.position, surface.geometric_normal,
                     offset_at<L>(point.position, radius)};
    if (group.is_curved) {
        start = start_on_curve<L>(point, surface.from_behind, wo, start);
    }
    store<L>(start.position, vertices.position, first);
    store<L>(start.normal, vertices.geometric_normal, first);
    store<L>(surface.normal, vertices.normal, first);
    store<L>(start.offset, vertices.offset, first);
    store<L>(surface.base, vertices.base, first);
    if (task.vertices.numbers != nullptr) {
        store_numbers<L>(task, surface, first);
    }
    if (task.scene.materials.transmits) {
        store<L>(L::select_int(surface.from_behind, L::all_int(1), L::all_int(0)),
                 vertices.from_behind, first);
    }
    if (group.absorbs && task.scene.absorbs) {
        absorb<L>(task, hit, surface.from_behind);
    }
}
