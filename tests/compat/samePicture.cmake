# cmake -D LAB=... -D SWTRACER=... -D SCENE=... -D COMPARE=... -P samePicture.cmake
# Runs a lab program, which writes out.png, and ours; fails unless both make the same picture.
file(REMOVE out.png ours.png)
execute_process(COMMAND ${LAB} COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${SWTRACER} ${SCENE} --samples 1 --size 128x128 --quiet -o ours.png
  COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${COMPARE} out.png ours.png COMMAND_ERROR_IS_FATAL ANY)
