target_sources(fff_core PRIVATE
    templates/chain_closing.cpp
    templates/cut_chains.cpp
    templates/cut_plane.cpp
    templates/cut_segments.cpp
    templates/guide_curve.cpp
    templates/loop_nesting.cpp
    templates/magnetic_cut.cpp
    templates/mended_mesh.cpp
    templates/mesh_edges.cpp
    templates/mesh_report.cpp
    templates/mesh_tree.cpp
    templates/placed_mesh.cpp
    templates/plane_cut.cpp
    templates/triangle_mesh.cpp
    templates/vertex_merger.cpp
    templates/vertex_normals.cpp
)
