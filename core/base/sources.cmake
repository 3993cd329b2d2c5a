target_sources(fff_core PRIVATE
    base/fault_point.cpp
    base/message.cpp)
# Else only headers: result.h, ids.h, text.h, tolerances.h, units.h
