#include "ui/base/spare_memory.h"

#include <cstdlib> // says whether the library is GNU's

#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace fff::ui {

void giveBackSpareMemory()
{
#ifdef __GLIBC__
    malloc_trim(0);
#endif
}

} // namespace fff::ui
