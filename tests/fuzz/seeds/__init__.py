"""Seeds and words of the fuzz targets: inputs that are good, so that changes of them get past the first check. They are
made at each run of what the project has: the cases of tests/conformance, api/examples, api/schemas and deploy/demo.
"""
