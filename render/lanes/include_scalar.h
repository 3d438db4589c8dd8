// Includes the kernels that CAROM_KERNELS names, for one number at a time. For the scalar_kernels.h
// of each folder, which includes first what the kernels read.

namespace carom::render::scalar {

#define CAROM_KERNEL [[gnu::always_inline]] inline
#define CAROM_KERNEL_OUTLINED [[gnu::noinline]] inline
#define CAROM_KERNEL_ATTRIBUTE
#include CAROM_KERNELS
#undef CAROM_KERNEL
#undef CAROM_KERNEL_OUTLINED
#undef CAROM_KERNEL_ATTRIBUTE
#undef CAROM_KERNELS

}  // namespace carom::render::scalar
