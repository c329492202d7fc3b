# keyword decks -> Model
target_sources(corpuscle_io PRIVATE
    deck.cpp keyword_table.cpp deck_fingerprint.cpp deck_mesh.cpp deck_places.cpp rigid_start.cpp solid_skin.cpp loose_ends.cpp
    # text -> cards
    faults.cpp text.cpp lines.cpp keyword_reader.cpp
    expression.cpp parameters.cpp parameter_cards.cpp
    card.cpp cards.cpp
    # cards -> scene, a file a family
    keywords/table.cpp
    keywords/nodes_elements.cpp
    keywords/parts_sections.cpp
    keywords/materials.cpp
    keywords/mat_fabric.cpp
    keywords/curves.cpp
    keywords/coordinates.cpp
    keywords/transformation.cpp
    keywords/sets.cpp
    keywords/sets_general.cpp
    keywords/airbag_particle.cpp
    keywords/airbag_chambers.cpp
    keywords/airbag_gas.cpp
    keywords/mole_fraction.cpp
    keywords/airbag_uniform.cpp
    keywords/airbag_hybrid.cpp
    keywords/airbag_vents.cpp
    keywords/reference_geometry.cpp
    keywords/rigid_parts.cpp
    keywords/rigid_merges.cpp
    keywords/joined_nodes.cpp
    keywords/joints.cpp
    keywords/leakage.cpp
    keywords/links.cpp
    keywords/boundary.cpp
    keywords/motion.cpp
    keywords/initial_velocity.cpp
    keywords/loads.cpp
    keywords/contact.cpp
    keywords/contact_surface.cpp
    keywords/contact_tied.cpp
    keywords/walls.cpp
    keywords/walls_geometric.cpp
    keywords/database_sensor.cpp
    keywords/control_output.cpp)
