// Makes the header that the tests share; see tests/CMakeLists.txt.
