fff_tests(tests_session LIBRARIES fff::session Polyclipping::Polyclipping TESTS
    core/session/tst_accurate
    core/session/tst_assembly_plan
    core/session/tst_assembly_steps
    core/session/tst_autosave
    core/session/tst_bad_loads
    core/session/tst_bearing_map
    core/session/tst_bent_model
    core/session/tst_case_models
    core/session/tst_check_actions
    core/session/tst_check_list
    core/session/tst_checks
    core/session/tst_cutlery_holder
    core/session/tst_doubted_verdicts
    core/session/tst_failures
    core/session/tst_flips
    core/session/tst_flat_template_commands
    core/session/tst_gap
    core/session/tst_hands
    core/session/tst_hard_crossings
    core/session/tst_layout_models
    core/session/tst_load_points
    core/session/tst_loads_on_copies
    core/session/tst_loose_pieces
    core/session/tst_many_sections
    core/session/tst_mark_distances
    core/session/tst_operation_commands
    core/session/tst_own_finding
    core/session/tst_pen_scripts
    core/session/tst_plan_checks
    core/session/tst_plan_growth
    core/session/tst_replay
    core/session/tst_scheduler
    core/session/tst_section_names
    core/session/tst_session
    core/session/tst_slit_ends
    core/session/tst_strength
    core/session/tst_strength_edits
    core/session/tst_strength_findings
    core/session/tst_stretching
    core/session/tst_strokes
    core/session/tst_template_commands
    core/session/tst_template_laws
    core/session/tst_they_fit
    core/session/tst_tool_replays
    core/session/tst_trial_words
    core/session/tst_value_trials
    core/session/tst_view_fit
    core/session/tst_what_carries
    core/session/tst_wider_necks
    ALONE
        core/physics/reference_case
        core/session/tst_case_models
        core/session/tst_strength
        core/session/tst_tool_replays)
target_sources(tests_session PRIVATE
    bench/generated_models.cpp
    core/physics/reference_case.cpp
    core/physics/reference_truth.cpp
    core/session/staged.cpp)
target_compile_definitions(tests_session PRIVATE FFF_SAMPLES="${CMAKE_SOURCE_DIR}/resources/samples")

# Samples over the ranges of their values.
fff_tests(tests_adjustable LIBRARIES fff::session TESTS core/session/tst_adjustable_samples)
target_compile_definitions(tests_adjustable PRIVATE
    FFF_SAMPLES="${CMAKE_SOURCE_DIR}/resources/samples")

# How parts lie on their sheets.
fff_tests(tests_sheets LIBRARIES fff::session TESTS
    core/session/tst_sheet_wishes
    core/session/tst_sheets)

# They count what is allocated in all of the program.
fff_tests(tests_memory LIBRARIES fff::session TESTS
    core/session/tst_analysis
    core/session/tst_history)
target_sources(tests_memory PRIVATE bench/counted_memory.cpp bench/generated_models.cpp)

# A program of its own: it sets the registers of a process that it starts.
if(CMAKE_SYSTEM_NAME STREQUAL "Linux" AND CMAKE_SYSTEM_PROCESSOR STREQUAL "x86_64")
    fff_tests(tests_stopped_writer LIBRARIES fff::session TESTS core/session/tst_stopped_writer)
endif()

# What joints hold, by an oracle of its own.
fff_tests(tests_held LIBRARIES fff::session TESTS
    core/session/tst_around_an_axis
    core/session/tst_folding
    core/session/tst_grips
    core/session/tst_finding_rows
    core/session/tst_held_judge
    core/session/tst_held_pairs
    core/session/tst_mending)
target_sources(tests_held PRIVATE
    core/session/broken_models.cpp
    core/session/edge_grid.cpp
    core/session/held_judge.cpp
    core/session/held_pairs.cpp
    core/session/judged_piece.cpp
    core/session/mend_trial.cpp
    core/session/random_drawings.cpp
    core/session/staged.cpp
    core/session/weak_models.cpp)
target_compile_definitions(tests_held PRIVATE FFF_SAMPLES="${CMAKE_SOURCE_DIR}/resources/samples")

# What must not change how strong a model is: on all models that there are, and random ones.
fff_tests(tests_laws LIBRARIES fff::session TESTS core/session/tst_strength_laws)
target_sources(tests_laws PRIVATE core/session/law_models.cpp core/session/random_drawings.cpp)
target_compile_definitions(tests_laws PRIVATE FFF_SAMPLES="${CMAKE_SOURCE_DIR}/resources/samples")

# Suggested sections of meshes made by code; the table beside an even grid is printed by hand.
fff_tests(tests_suggestion LIBRARIES fff::session TESTS core/session/tst_suggestion)
target_sources(tests_suggestion PRIVATE core/session/suggested_forms.cpp)
add_executable(suggestion_table EXCLUDE_FROM_ALL
    core/session/suggestion_table.cpp
    core/session/suggested_forms.cpp)
target_link_libraries(suggestion_table PRIVATE fff::session fff_common Qt6::Gui Eigen3::Eigen)
