# CLI11 takes 5 to 10 seconds in each file that includes it: all of them at once.
set_target_properties(swtracer_program PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
set_source_files_properties(
  app/extraOptions.cpp app/help.cpp app/options.cpp app/usage.cpp app/validators.cpp
  PROPERTIES UNITY_GROUP commandLine)
