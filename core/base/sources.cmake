target_sources(fff_core PRIVATE
    base/fault_point.cpp)
# Else only headers: result.h, ids.h, tolerances.h, units.h
