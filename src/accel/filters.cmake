# The filters have margins for rounding, so they may use fused multiply-adds.
set_source_files_properties(accel/shapeIndex.cpp PROPERTIES COMPILE_OPTIONS
  $<$<CXX_COMPILER_ID:GNU,Clang,AppleClang>:-ffp-contract=fast>)
