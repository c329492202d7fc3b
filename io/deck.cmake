# keyword decks -> Model
target_sources(corpuscle_io PRIVATE
    deck.cpp deck_mesh.cpp deck_parameters.cpp
    # text -> cards
    deck/card.cpp deck/card_faults.cpp deck/cards.cpp deck/comment_settings.cpp deck/deck_fingerprint.cpp
    deck/deck_places.cpp deck/deck_words.cpp deck/expression.cpp deck/faults.cpp
    deck/keyword_reader.cpp deck/lines.cpp deck/parameter_cards.cpp deck/parameters.cpp
    deck/included/card_ids.cpp deck/included/file_names.cpp deck/included/file_place.cpp deck/included/inclusion.cpp
    # cards -> scene, a file a family
    keywords/control_output.cpp keywords/curves.cpp keywords/database_sensor.cpp keywords/keyword_table.cpp
    keywords/remarks.cpp keywords/table.cpp keywords/tasks.cpp
    keywords/airbag/airbag_chambers.cpp
    keywords/airbag/airbag_gas.cpp
    keywords/airbag/cpm_gas.cpp
    keywords/airbag/airbag_hybrid.cpp
    keywords/airbag/airbag_particle.cpp
    keywords/airbag/airbag_uniform.cpp
    keywords/airbag/airbag_vents.cpp
    keywords/airbag/airbag_wang_nefske.cpp
    keywords/airbag/leakage.cpp
    keywords/airbag/mole_fraction.cpp
    keywords/bodies/deformable_to_rigid.cpp
    keywords/bodies/joined_nodes.cpp
    keywords/bodies/joint_stiffness.cpp
    keywords/bodies/joints.cpp
    keywords/bodies/links.cpp
    keywords/bodies/rigid_merges.cpp
    keywords/bodies/rigid_parts.cpp
    keywords/contact/contact.cpp
    keywords/contact/contact_surface.cpp
    keywords/contact/contact_tied.cpp
    keywords/contact/walls.cpp
    keywords/contact/walls_geometric.cpp
    keywords/materials/mat_fabric.cpp
    keywords/materials/materials.cpp
    keywords/materials/part_composite.cpp
    keywords/materials/parts_sections.cpp
    keywords/mesh/coordinates.cpp
    keywords/mesh/element_state.cpp
    keywords/mesh/nodes_elements.cpp
    keywords/mesh/reference_geometry.cpp
    keywords/mesh/set_order.cpp
    keywords/mesh/sets.cpp
    keywords/mesh/sets_general.cpp
    keywords/mesh/transformation.cpp
    keywords/motion/boundary.cpp
    keywords/motion/initial_velocity.cpp
    keywords/motion/loads.cpp
    keywords/motion/loads_rigid.cpp
    keywords/motion/motion.cpp
    # what no single keyword sees
    model/beam_bodies.cpp model/held_bodies.cpp model/loose_ends.cpp model/merged_loads.cpp model/motion_check.cpp model/numbering.cpp model/part_remarks.cpp model/solid_skin.cpp model/file_places.cpp model/transformation.cpp)
