# Only headers: result.h, ids.h, tolerances.h, units.h
