target_sources(fff_core PRIVATE
    physics/balance.cpp
    physics/block_system.cpp
    physics/component_net.cpp
    physics/components.cpp
    physics/contact_search.cpp
    physics/equilibrium.cpp
    physics/indeterminacy.cpp
    physics/link_stiffness.cpp
)
