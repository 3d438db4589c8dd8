// Reading and writing the numbers of queues (path_queues.h), in lanes. Included as
// render/lanes/kernels/vectors.h is. `i`: the place of the first lane; the others follow it.

template <class L>
CAROM_KERNEL ValueOf<L> load(const Floats& numbers, int i) {
    return L::load(numbers.at + i);
}
template <class L>
CAROM_KERNEL Vec3Of<L> load(const Floats3& numbers, int i) {
    return {load<L>(numbers.x, i), load<L>(numbers.y, i), load<L>(numbers.z, i)};
}
template <class L>
CAROM_KERNEL IntOf<L> load(const Words& words, int i) {
    return L::load_int(words.at + i);
}

template <class L>
CAROM_KERNEL void store(ValueOf<L> value, const Floats& numbers, int i) {
    L::store(value, numbers.at + i);
}
template <class L>
CAROM_KERNEL void store(const Vec3Of<L>& value, const Floats3& numbers, int i) {
    store<L>(value.x, numbers.x, i);
    store<L>(value.y, numbers.y, i);
    store<L>(value.z, numbers.z, i);
}
template <class L>
CAROM_KERNEL void store(IntOf<L> value, const Words& words, int i) {
    L::store_int(value, words.at + i);
}

template <class L>
CAROM_KERNEL ValueOf<L> gather(const Floats& numbers, IntOf<L> index) {
    return L::gather(numbers.at, index);
}
template <class L>
CAROM_KERNEL Vec3Of<L> gather(const Floats3& numbers, IntOf<L> index) {
    return {gather<L>(numbers.x, index), gather<L>(numbers.y, index), gather<L>(numbers.z, index)};
}
template <class L>
CAROM_KERNEL IntOf<L> gather(const Words& words, IntOf<L> index) {
    return L::gather_int(words.at, index);
}
template <class L>
CAROM_KERNEL void scatter(const Vec3Of<L>& value, const Floats3& numbers, IntOf<L> index) {
    L::scatter(value.x, numbers.x.at, index);
    L::scatter(value.y, numbers.y.at, index);
    L::scatter(value.z, numbers.z.at, index);
}

template <class L>
CAROM_KERNEL IntOf<L> gather(const List<std::int32_t>& list, IntOf<L> index) {
    return L::gather_int(list.data(), index);
}

/// A row of numbers, and three rows, at each lane's index.
template <class L>
CAROM_KERNEL ValueOf<L> gather(const NumberRows& rows, int row, IntOf<L> index) {
    return L::gather(rows.row(row), index);
}
template <class L>
CAROM_KERNEL Vec3Of<L> gather_vector(const NumberRows& rows, int row, IntOf<L> index) {
    return {gather<L>(rows, row, index), gather<L>(rows, row + 1, index),
            gather<L>(rows, row + 2, index)};
}

/// The random numbers of the camera samples in the slots of a wave.
template <class L>
CAROM_KERNEL SamplerOf<L> sampler_of(const CameraSamples& samples, IntOf<L> slot) {
    return SamplerOf<L>(L::to_word(gather<L>(samples.pixel_hash, slot)),
                        L::to_word(gather<L>(samples.reversed_sample, slot)));
}
