# SPDX-License-Identifier: GPL-2.0-or-later
# Which stock sources are compiled together. Most of them are short, and reading the same headers
# takes longer than compiling them: a group reads them once.
#
# Not in a group, so compiled alone:
# - what a granular run spends its time in (pair styles, neighbour lists, multispheres, walls,
#   communication, spheres' atoms and integration): compiled exactly as ever;
# - what reads a list of styles that ours are in (style_fix.h and its like): changes often;
# - what declares a name that some other source gives another meaning (enum { NONE, X, ... }) and
#   found no group where it has none; the compiler refuses such a pair.
# A source that a tree lacks is passed over, one that is not named here is compiled alone.

# Steps, computes and models: optimised as ever.
set(stock_groups
  computes_1 computes_2 computes_3 bonds atoms sph coupling fixes_1 fixes_2 fixes_3 insertion mesh
  regions)
set(stock_computes_1 compute compute_atom_molecule compute_bond_local compute_centro_atom
  compute_cluster_atom compute_cna_atom compute_com compute_com_molecule compute_contact_atom
  compute_contact_atom_gran compute_coord_atom)
set(stock_computes_2 compute_displace_atom compute_erotate compute_erotate_asphere
  compute_erotate_multisphere compute_erotate_sphere compute_erotate_sphere_atom
  compute_erotate_superquadric compute_group_group compute_gyration compute_gyration_molecule
  compute_inertia_molecule compute_ke compute_ke_atom compute_ke_multisphere)
set(stock_computes_3 compute_msd compute_msd_molecule compute_nparticles_tracer_region
  compute_pair_gran_local compute_pe compute_pe_atom compute_pressure compute_property_atom
  compute_property_local compute_property_molecule compute_rdf compute_reduce compute_rigid
  compute_stress_atom compute_temp)
set(stock_bonds angle angle_hybrid bond bond_harmonic bond_hybrid dihedral dihedral_hybrid
  fix_minimize fix_respa fix_spring fix_spring_rg fix_spring_self improper improper_hybrid kspace min
  min_cg minimize neigh_bond neigh_respa respa)
set(stock_atoms atom_vec_atomic atom_vec_charge atom_vec_ellipsoid atom_vec_full atom_vec_hybrid
  atom_vec_line atom_vec_molecular atom_vec_superquadric atom_vec_tri
  math_extra_liggghts_nonspherical math_extra_liggghts_superquadric superquadric)
set(stock_sph atom_vec_sph atom_vec_sph_var fix_check_timestep_sph fix_nve_sph
  fix_nve_sph_stationary fix_sph fix_sph_density_continuity fix_sph_density_corr
  fix_sph_density_summation fix_sph_pressure fix_wall_region_sph fix_wall_sph pair_sph
  pair_sph_artvisc_tenscorr)
set(stock_coupling cfd_datacoupling cfd_datacoupling_file cfd_datacoupling_mpi cfd_regionmodel_none
  fix_buoyancy fix_cfd_coupling fix_cfd_coupling_convection fix_cfd_coupling_convection_impl
  fix_cfd_coupling_convection_species fix_cfd_coupling_force fix_cfd_coupling_force_implicit
  fix_continuum_weighted fix_efield fix_fiber_spring_simple fix_heat_gran fix_heat_gran_conduction
  fix_lb_coupling_onetoone fix_scalar_transport_equation library_cfd_coupling)
set(stock_fixes_1 fix_adapt fix_ave_atom fix_ave_euler fix_base_liggghts fix_box_relax
  fix_check_timestep_gran fix_contact_property_atom fix_contact_property_atom_wall fix_deform_check
  fix_diam_max fix_drag fix_dt_reset fix_enforce2d fix_external)
set(stock_fixes_2 fix_aveforce fix_freeze fix_lineforce fix_massflow_mesh fix_massflow_mesh_sieve
  fix_momentum fix_multicontact_halfspace fix_planeforce fix_region_variable fix_store
  fix_store_force)
set(stock_fixes_3 fix_ave_time fix_nve fix_nve_asphere fix_nve_asphere_base fix_nve_asphere_noforce
  fix_nve_limit fix_nve_line fix_nve_noforce fix_nve_superquadric fix_property_atom_region_tracer
  fix_property_atom_tracer fix_property_atom_tracer_stream fix_setforce fix_viscous fix_wall_region)
set(stock_insertion fix_insert fix_insert_pack fix_insert_rate_region fix_insert_stream
  fix_particledistribution_discrete fix_template_multiplespheres fix_template_multisphere
  fix_template_sphere fix_template_superquadric particleToInsert particleToInsertSuperquadric
  particleToInsert_multisphere region_sphere)
set(stock_mesh fix_mesh fix_move_mesh mesh_module mesh_module_liquidtransfer mesh_module_stress
  mesh_mover_linear mesh_mover_rotation region region_cylinder region_mesh_tet tri_mesh_planar)
set(stock_regions bounding_box container_base custom_value_tracker fix_store_state properties
  property_registry random random_mars random_park region_block region_cone
  region_intersect region_neighbor_list region_plane region_prism region_union region_wedge rotate)

# Input, output and commands: a run meets them now and then, so they are optimised less.
set(stock_rare_groups dumps_1 dumps_2 dumps_3 files commands_1 commands_2)
set(stock_dumps_1 dump dump_atom_vtk dump_custom dump_custom_vtm dump_decomposition_vtk dump_euler_vtk)
set(stock_dumps_2 dump_image dump_local dump_local_gran_vtk dump_mesh dump_mesh_stl dump_mesh_vtk
  dump_mesh_vtm dump_movie dump_vtk dump_xyz)
set(stock_dumps_3 dump_particle image)
set(stock_files fix_print fix_read_restart input_mesh_tet input_mesh_tri read_data read_dump reader
  write_data)
set(stock_commands_1 change_box create_atoms create_box delete_atoms delete_bonds
  replicate special)
set(stock_commands_2 citeme displace_atoms error finish global_properties group info lattice library
  modified_andrew run_time signal_handling thermo timer universe)
