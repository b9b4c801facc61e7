# SPDX-FileCopyrightText: 2026 The deburr authors
# SPDX-License-Identifier: Apache-2.0
# Called before the compiler: takes the objects of the library from another build, BUILD, of the
# same sources, and compiles what else CMake tries:
#   sh take_object.sh BUILD COMPILER ... -o OBJECT ...
build=$1
shift
last=
for word in "$@"; do
  [ "$last" = -o ] && object=$word
  last=$word
done
case $object in
  CMakeFiles/deburr.dir/*) exec cp "$build/$object" "$object" ;;
  *) exec "$@" ;;
esac
