// Includes the kernels that CAROM_KERNELS names, for vector lanes of one instruction set. For the
// kernels-inl.h of each folder, which includes first what the kernels read.

HWY_BEFORE_NAMESPACE();
namespace carom::render::HWY_NAMESPACE {

#define CAROM_KERNEL HWY_INLINE
#define CAROM_KERNEL_OUTLINED HWY_NOINLINE HWY_ATTR
#define CAROM_KERNEL_ATTRIBUTE HWY_ATTR
#include CAROM_KERNELS
#undef CAROM_KERNEL
#undef CAROM_KERNEL_OUTLINED
#undef CAROM_KERNEL_ATTRIBUTE
#undef CAROM_KERNELS

}  // namespace carom::render::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
