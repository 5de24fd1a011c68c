# SPDX-License-Identifier: GPL-2.0-or-later
# What is mended in the staged copy of LIGGGHTS 3.8.0, and why: doc/background/stock_mends.md says it for users.
# Included by StageLiggghts.cmake, whose mend(FOLDER FILE OLD NEW) replaces a text or stops.

# Our helpers come in behind the own error.h of a source.
function(include_in folder name header)
  mend(${folder} ${name} "#include \"error.h\"" "#include \"error.h\"
#include \"${header}\"")
endfunction()

# What today's compilers reject.
function(mend_for_compilers folder)
  mend(${folder} utils.h
    "static_cast< std::ostringstream & >(( std::ostringstream() << std::dec << a ) ).str()"
    "std::to_string(a)")
  mend(${folder} finish.cpp "lists[m]->numneigh > 0" "lists[m]->numneigh != nullptr")
endfunction()

# What is said arrives, on the screen and in the log, whatever they are and whoever says it.
function(mend_messages folder)
  # One error in five is followed by a joke, printed from a string that is gone by then: garbage.
  mend(${folder} error_special.h "return msg.c_str()" "return 0")
  # MPI_Abort throws away what waits in a buffer, and the log had nothing of an error of one rank.
  include_in(${folder} error.cpp stock_streams.h)
  mend(${folder} error.cpp "void Error::one(const char *file, int line, const char *str)
{" "void Error::one(const char *file, int line, const char *str)
{
  rodpack::error_to_log(lmp,file,line,str);")
  mend(${folder} error.cpp "MPI_Abort(world,1)" "rodpack::abort_run(lmp,world)")
  mend(${folder} error.cpp "MPI_Abort(universe->uworld,1)" "rodpack::abort_run(lmp,universe->uworld)")
  include_in(${folder} lammps.cpp stock_streams.h)
  mend(${folder} lammps.cpp "  // make universe and single world the same, since no partition switch"
    "  rodpack::keep_log(universe->ulogfile,logflag ? arg[logflag] : \"log.liggghts\");

  // universe and world are the same, since no partition switch")
  include_in(${folder} input.cpp stock_streams.h)
  mend(${folder} input.cpp "    if (universe->nworlds == 1) universe->ulogfile = logfile;
  }" "    if (universe->nworlds == 1) universe->ulogfile = logfile;
  }
  rodpack::keep_log(logfile,arg[0]);")
  # A setting of a contact model without a value took what lies behind the end of the line for one,
  # and a wrong value was not told what is right.
  mend(${folder} settings.h "        consumed = it->second->parseArguments(remaining_args);"
    "        if(remaining == 1 && it->second->name == remaining_args[0]) {
          error_message = \"'\" + it->second->name + \"' needs a value\";
          return false;
        }
        consumed = it->second->parseArguments(remaining_args);")
  mend(${folder} settings.h "<< args[1] << \"'\";" "<< args[1] << \"', expected\";
      for(typename std::map<std::string, T>::iterator it = options.begin(); it != options.end(); ++it)
        ss << (it == options.begin() ? \" \" : \" or \") << it->first;")
  # Without a screen (`-screen none`, ranks beside one that writes to a file), much of stock LIGGGHTS wrote
  # to a null pointer: its reader of meshes, its insertion, its models.
  foreach(old
      "universe->uscreen = NULL;"
      "\"none\") == 0)
         screen = NULL;"
      "\"none\") == 0)
        screen = NULL;"
      "} else screen = NULL;")
    string(REPLACE "= NULL;" "= fopen(\"/dev/null\",\"w\");" new "${old}")
    mend(${folder} lammps.cpp "${old}" "${new}")
  endforeach()
  # They come with every run of bodies and hide the warnings that mean something. That thermo's own
  # kinetic energy is not that of bodies is said where it is printed.
  mend(${folder} fix_property_atom.cpp
    "    if (narg > 29) error->warning(FLERR,\"Vector length in fix property/atom larger than 20. Are you sure you want that?\");
" "")
  mend(${folder} fix_multisphere.cpp
    "    if(0 == comm->me)
        error->warning(FLERR,\"Energy calculated for multisphere particles is currently not correct\");
" "")
  include_in(${folder} thermo.cpp stock_streams.h)
  mend(${folder} thermo.cpp "void Thermo::compute_ke()
{" "void Thermo::compute_ke()
{
  rodpack::warn_of_kinetic_energy(lmp);")
endfunction()

# What cannot be written stops the run at once, with a line that says so.
function(mend_writing folder)
  # Closed pipes and limits of file sizes are errors of a write, not silent ends of the program.
  mend(${folder} main.cpp "#include \"signal_handling.h\"" "#include \"signal_handling.h\"
#include \"stock_streams.h\"")
  mend(${folder} main.cpp "  MPI_Init(&argc,&argv);" "  rodpack::let_writes_fail();
  MPI_Init(&argc,&argv);")
  mend(${folder} main.cpp "  lammps->input->file();
  delete lammps;

  MPI_Finalize();" "  lammps->input->file();
  rodpack::check_streams(lammps);
  delete lammps;

  MPI_Finalize();
  return SignalHandler::request_quit ? 1 : 0;")
  mend(${folder} input.cpp "    if (SignalHandler::request_quit)
        return;
  }" "    rodpack::check_streams(lmp);
    if (SignalHandler::request_quit)
        return;
  }")
  mend(${folder} input.cpp "                fprintf(fp, \"%s\", line);
            fclose(fp);" "                fprintf(fp, \"%s\", line);
            rodpack::close_written(lmp,fp,\"the file of print\");")
  mend(${folder} thermo.cpp "      if (flushflag) fflush(thermofile);
    }
" "      if (flushflag) fflush(thermofile);
    }
    rodpack::check_streams(lmp);
")
  include_in(${folder} fix_print.cpp stock_streams.h)
  mend(${folder} fix_print.cpp "      fflush(fp);" "      rodpack::check_written(lmp,fp,\"the file of fix print\",id);")
  include_in(${folder} dump.cpp stock_streams.h)
  mend(${folder} dump.cpp "fflush(fp);" "rodpack::check_written(lmp,fp,\"dump\",filename);")
  mend(${folder} dump.cpp "if (filewriter) fclose(fp);"
    "if (filewriter) rodpack::close_written(lmp,fp,\"dump\",filename);")
  mend(${folder} dump.cpp "if (filewriter) pclose(fp);"
    "if (filewriter && pclose(fp) != 0) error->one(FLERR,\"Cannot write a compressed dump: gzip has failed\");")
  mend(${folder} dump.cpp "char gzip[128];" "char gzip[strlen(filecurrent) + 16];")
endfunction()

# A number of a command is its whole word, and in range; words that are none are named.
function(mend_numbers folder)
  foreach(source force run update)
    include_in(${folder} ${source}.cpp stock_numbers.h)
  endforeach()
  mend(${folder} force.cpp
    "error->all(file, line, \"Expected floating point parameter in input script or data file\");"
    "rodpack::refuse_number(error,input,file,line,\"a number\",str);")
  mend(${folder} force.cpp
    "error->all(file, line, \"Expected integer parameter in input script or data file\");"
    "rodpack::refuse_number(error,input,file,line,\"an integer\",str);")
  # `error` where there is one: the first numbers are read before the object is made whose members these are.
  mend(${folder} force.cpp "const double val = atof(dstr);" "double val = 0.;
    if (!rodpack::is_number(dstr,val)) rodpack::refuse_number(error,input,file,line,\"a finite number\",str);")
  mend(${folder} force.cpp "const int val = atoi(istr);" "int val = 0;
    if (!rodpack::is_integer(istr,val))
      rodpack::refuse_number(error,input,file,line,\"an integer of at most 2147483647\",str);")
  foreach(word 0 iarg+1)
    mend(${folder} run.cpp "ATOBIGINT(arg[${word}])"
      "rodpack::whole_word_steps(error,input,FLERR,arg[${word}])")
  endforeach()
  mend(${folder} update.cpp "bigint newstep = ATOBIGINT(arg[0])"
    "bigint newstep = rodpack::whole_word_steps(error,input,FLERR,arg[0])")
endfunction()

# Restart files are whole, or refused. Their reader believed everything.
function(mend_restarts folder)
  include_in(${folder} write_restart.cpp restart_seal.h)
  mend(${folder} write_restart.cpp "fopen(hfile,\"wb\")" "rodpack::open_restart(hfile)")
  mend(${folder} write_restart.cpp "fopen(perproc,\"wb\")" "rodpack::open_restart(perproc)")
  mend(${folder} write_restart.cpp "fclose(fp);" "rodpack::close_restart(lmp,fp);")
  # Not after a day, when the first file is due.
  include_in(${folder} output.cpp restart_seal.h)
  mend(${folder} output.cpp "  if (restart == NULL) restart = new WriteRestart(lmp);
}" "  for (int k = 1; k < narg; k++) rodpack::require_folder_of_restart(lmp,arg[k]);
  if (restart == NULL) restart = new WriteRestart(lmp);
}")
  include_in(${folder} read_restart.cpp restart_seal.h)
  mend(${folder} read_restart.cpp
    "  if (narg != 1) error->all(FLERR,\"Illegal read_restart command\");"
    "  const bool unsealed = narg == 2 && strcmp(arg[1],\"unsealed\") == 0;
  if (narg != 1 && !unsealed)
    error->all(FLERR,\"Illegal read_restart command: expected 'read_restart FILE' or 'read_restart FILE unsealed'\");")
  mend(${folder} read_restart.cpp "    fp = fopen(hfile,\"rb\");
" "    rodpack::require_whole_restart(lmp,hfile,unsealed);
    fp = fopen(hfile,\"rb\");
")
  mend(${folder} read_restart.cpp "      fp = fopen(perproc,\"rb\");
" "      rodpack::require_whole_restart(lmp,perproc,unsealed);
      fp = fopen(perproc,\"rb\");
")
  # For whoever debugs, on every rank.
  mend(${folder} read_restart.cpp "            printf(\"version %d %d\\n\", restart_major, restart_minor);
" "")
endfunction()

# A contact that ends is handed to its models however far the pair has gone by then.
function(mend_contact_ends folder)
  mend(${folder} pair_gran_base.h "#include \"pair_gran.h\"" "#include \"pair_gran.h\"
#include \"contact_ends.h\"")
  mend(${folder} pair_gran_base.h "else if(rsq < contactDistanceMultiplier * radsum * radsum && "
    "else if((rsq < contactDistanceMultiplier * radsum * radsum || rodpack::wants_end(sidata.contact_flags)) && ")
  include_in(${folder} neigh_gran.cpp contact_ends.h)
  mend(${folder} neigh_gran.cpp "if (rsq < radsum*radsum)" "if (rsq < radsum*radsum || rodpack::ends_are_told())")
  include_in(${folder} fix_wall_gran.cpp contact_ends.h)
  mend(${folder} fix_wall_gran.cpp "    if(deltan <= 0 || deltan < contactDistanceMultiplier*radius[iPart])
" "    if(deltan <= 0 || deltan < contactDistanceMultiplier*radius[iPart] ||
       rodpack::wants_end(c_history ? c_history[iPart] : NULL,dnum_))
")
  mend(${folder} fix_wall_gran.cpp
    "if(deltan <= 0 || (radius && deltan < contactDistanceMultiplier*radius[iPart]))"
    "if(deltan <= 0 || (radius && deltan < contactDistanceMultiplier*radius[iPart]) ||
               rodpack::wants_end(fix_contact,iPart,idTri))")
endfunction()

# Whoever lists contacts is told of them, with the forces of the step.
function(mend_contact_reports folder)
  mend(${folder} pair_gran_base.h "#include \"contact_ends.h\"" "#include \"contact_ends.h\"
#include \"contact_reports.h\"")
  mend(${folder} pair_gran_base.h "    cmodel.beginPass(sidata, i_forces, j_forces);
" "    if (sidata.computeflag)
      rodpack::begin_contacts(lmp, pg, cmodel.get_history_offset(\"tangential_spring\"));
    cmodel.beginPass(sidata, i_forces, j_forces);
")
  mend(${folder} pair_gran_base.h "            const double relax_i = pg->relax(i);
" "            rodpack::report_contact(sidata, i_forces);
            const double relax_i = pg->relax(i);
")
  mend(${folder} fix_wall_gran.cpp "#include \"contact_ends.h\"" "#include \"contact_ends.h\"
#include \"contact_reports.h\"")
  mend(${folder} fix_wall_gran.cpp "void FixWallGran::post_force_wall(int vflag)
{
" "void FixWallGran::post_force_wall(int vflag)
{
  if (computeflag_ && impl)
    rodpack::begin_contacts(lmp, this, impl->get_history_offset(\"tangential_spring\"));

")
  mend(${folder} fix_wall_gran_base.h "#include \"granular_wall.h\"" "#include \"granular_wall.h\"
#include \"contact_reports.h\"")
  mend(${folder} fix_wall_gran_base.h "        if (sidata.has_force_update)
            force_update(f, torque, i_forces);
" "        if (sidata.has_force_update) {
            rodpack::report_contact(sidata, i_forces);
            force_update(f, torque, i_forces);
        }
")
  # Where the spring is in what a contact remembers.
  foreach(model history luding_tn)
    mend(${folder} tangential_model_${model}.h "hsetup->add_history_value(\"shearz\", \"1\");
" "hsetup->add_history_value(\"shearz\", \"1\");
      cmb->add_history_offset(\"tangential_spring\", history_offset);
")
  endforeach()
endfunction()

# The liquid bridge of a sphere and a wall: the wall was taken for a particle of a negative number, or of
# that of the triangle, whose velocity was read: a crash, or another particle's.
function(mend_bridges_at_walls folder)
  foreach(component 0 1 2)
    mend(${folder} cohesion_model_easo_capillary_viscous.h
      "v[i][${component}] - v[j][${component}]" "scdata.v_i[${component}] - scdata.v_j[${component}]")
  endforeach()
  mend(${folder} cohesion_model_easo_capillary_viscous.h
    "          double **v = atom->v;
" "")
  mend(${folder} cohesion_model_easo_capillary_viscous.h
    "double const *omega_j = atom->omega[j];"
    "double const *omega_j = scdata.is_wall ? NULL : atom->omega[j];")
endfunction()

# The inertia tensor of a template of spheres: I_zy was averaged with I_zx.
function(mend_inertia folder)
  mend(${folder} fix_template_multisphere.cpp "moi_[2][1] = (moi_[2][1]+moi_[2][0])/2.;"
    "moi_[2][1] = (moi_[2][1]+moi_[1][2])/2.;")
endfunction()

# A sphere on the axis of a primitive cylinder: every direction leads to the wall. It was said to touch it, in no
# direction: NaN from then on.
function(mend_axis_of_cylinder folder)
  mend(${folder} primitive_wall_definitions.h
    "delta[d::x] = 0.; delta[d::y] = 0.; delta[d::z] = 0.;
            dx = 0.0;
            return dx; // break for zero dist (avoid devide-by-zero)"
    "delta[d::x] = 0.; delta[d::y] = *param - dist; delta[d::z] = 0.;
            return *param - dist - r;")
endfunction()

# `dump_modify sort -N` on several ranks: the first rank, which is written first, had the lowest values.
function(mend_descending_sort folder)
  mend(${folder} sort_buffer.cpp
    "iproc = static_cast<int> ((value-minall)/range * nprocs);
                proclist[i] = iproc;"
    "iproc = static_cast<int> ((value-minall)/range * nprocs);
                proclist[i] = sortorder == DESCEND ? nprocs-1-iproc : iproc;")
endfunction()

function(mend_stock folder)
  mend_for_compilers(${folder})
  mend_messages(${folder})
  mend_writing(${folder})
  mend_numbers(${folder})
  mend_restarts(${folder})
  mend_contact_ends(${folder})
  mend_contact_reports(${folder})
  mend_bridges_at_walls(${folder})
  mend_axis_of_cylinder(${folder})
  mend_descending_sort(${folder})
  mend_inertia(${folder})
endfunction()
