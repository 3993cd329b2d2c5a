target_sources(fff_core PRIVATE
    analysis/analysis.cpp
    analysis/assembly_plan.cpp
    analysis/check_caches.cpp
    analysis/checks.cpp
    analysis/dropping.cpp
    analysis/flips.cpp
    analysis/gap.cpp
    analysis/joining_move.cpp
    analysis/narrow_slits.cpp
    analysis/plan_checks.cpp
    analysis/stretching.cpp
    analysis/touching.cpp
)
